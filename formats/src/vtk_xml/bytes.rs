//! The bytes of an array: plain, compressed, as Base64.

use std::io::{self, Write};

use flate2::Compression;
use flate2::write::ZlibEncoder;

use crate::arrays::{Array, Block, Kind};

/// The bytes of a header of one number.
pub(super) const HEADER: u64 = 8;

/// The bytes of the numbers.
pub(super) fn length(array: &Array) -> u64 {
    let size = match array.kind {
        Kind::Float64 | Kind::Int64 => 8,
        Kind::Int32 => 4,
        Kind::UInt8 => 1,
    };
    (array.length * size) as u64
}

/// Hands on the number of bytes, then the bytes.
pub(super) fn raw(array: &Array, mut take: impl FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
    take(&length(array).to_le_bytes())?;
    numbers(array, take)
}

/// Hands on the bytes of the numbers, little endian.
fn numbers(array: &Array, mut take: impl FnMut(&[u8]) -> io::Result<()>) -> io::Result<()> {
    let mut bytes = Vec::new();
    array.blocks(|block| {
        bytes.clear();
        match (block, array.kind) {
            (Block::Real(values), _) => fill(&mut bytes, values, |value| value.to_le_bytes()),
            (Block::Whole(values), Kind::UInt8) => fill(&mut bytes, values, |value| [value as u8]),
            (Block::Whole(values), Kind::Int32) => {
                fill(&mut bytes, values, |value| (value as i32).to_le_bytes());
            }
            (Block::Whole(values), _) => fill(&mut bytes, values, |value| value.to_le_bytes()),
        }
        take(&bytes)
    })
}

fn fill<T: Copy, const N: usize>(bytes: &mut Vec<u8>, values: &[T], number: impl Fn(T) -> [u8; N]) {
    bytes.resize(N * values.len(), 0);
    for (place, &value) in bytes.chunks_exact_mut(N).zip(values) {
        place.copy_from_slice(&number(value));
    }
}

/// Bytes that are compressed at once, as VTK does it.
const BLOCK: usize = 1 << 15;

/// The header and the blocks of an array: how many blocks, the bytes of a block, those of the last
/// one if it is smaller (else 0), and for each block its compressed bytes.
pub(super) fn compressed(array: &Array) -> io::Result<[Vec<u8>; 2]> {
    let mut sizes: Vec<u64> = Vec::new();
    let mut blocks = Vec::new();
    let mut pack = |bytes: &[u8]| {
        let before = blocks.len();
        let mut encoder = ZlibEncoder::new(&mut blocks, Compression::default());
        encoder.write_all(bytes)?;
        encoder.finish()?;
        sizes.push((blocks.len() - before) as u64);
        io::Result::Ok(())
    };
    let mut waiting: Vec<u8> = Vec::new();
    numbers(array, |bytes| {
        waiting.extend_from_slice(bytes);
        let whole = waiting.len() / BLOCK * BLOCK;
        waiting[..whole].chunks(BLOCK).try_for_each(&mut pack)?;
        waiting.drain(..whole);
        Ok(())
    })?;
    if !waiting.is_empty() {
        pack(&waiting)?;
    }
    let mut header = vec![sizes.len() as u64, BLOCK as u64, waiting.len() as u64];
    header.append(&mut sizes);
    Ok([header.into_iter().flat_map(u64::to_le_bytes).collect(), blocks])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arrays_are_compressed_in_blocks() {
        for (numbers, blocks, last) in [(0, 0, 0), (3, 1, 12), (8192, 1, 0), (20_000, 3, 14_464)] {
            let array = Array::whole("a", Kind::Int32, numbers, |i| i as i64);
            let [header, packed] = compressed(&array).unwrap();
            let header: Vec<u64> =
                header.chunks(8).map(|word| u64::from_le_bytes(word.try_into().unwrap())).collect();
            assert_eq!(header[..3], [blocks, 1 << 15, last], "{numbers} numbers");
            assert_eq!(header.len() as u64, 3 + blocks);
            assert_eq!(header[3..].iter().sum::<u64>(), packed.len() as u64);
            let mut found = Vec::new();
            let mut rest = &packed[..];
            for &size in &header[3..] {
                let (block, others) = rest.split_at(size as usize);
                let mut decoder = flate2::write::ZlibDecoder::new(&mut found);
                decoder.write_all(block).unwrap();
                decoder.finish().unwrap();
                rest = others;
            }
            let expected: Vec<u8> = (0..numbers as i32).flat_map(i32::to_le_bytes).collect();
            assert_eq!(found, expected);
        }
    }
}
