//! How mesh files are written: what may be asked for, and the one place that leads from a format
//! to its writer.

use std::io::{self, Write};

use clap::Args;
use meshwright::formats::groups::Note;
use meshwright::formats::msh::Version;
use meshwright::formats::{Mesh, Order, edge, ele, gltf, msh, neigh, node, poly, vtu};

use super::failure::Failure;
use super::format::{Format, listed};
use super::words::{MSH_VERSIONS, ORDERS, one_of, word};

/// How mesh files are written: the same options for every command that writes one.
#[derive(Debug, Clone, Copy, Default, Args)]
pub struct WriteOptions {
    /// The version of .msh files: 2.2, which most programs read, or 4.1, where an edge in several
    /// groups is one element [default: 2.2].
    #[arg(long, value_name = "VERSION", value_parser = one_of(MSH_VERSIONS))]
    msh_version: Option<Version>,
    /// Numbers as bytes (.msh): smaller and faster; without it text, which more programs read.
    #[arg(long)]
    binary: bool,
    /// Elements with a node in the middle of each side (2: .msh), or with corners alone (1); the
    /// sides stay straight [default: 1].
    #[arg(long, value_name = "ORDER", value_parser = one_of(ORDERS))]
    order: Option<Order>,
    /// Renumber groups so that no number serves a boundary and a region (.msh); without it the
    /// outline's numbers stay.
    #[arg(long)]
    unique_ids: bool,
}

impl WriteOptions {
    /// Refuses an option that none of the files is about.
    pub fn check(&self, formats: &[Format]) -> Result<(), Failure> {
        type Takes = fn(Format) -> bool;
        let asked: [(bool, &str, Takes); 4] = [
            (self.msh_version.is_some(), "msh-version", |format| format == Format::Msh),
            (self.binary, "binary", |format| format == Format::Msh),
            (self.order == Some(Order::Second), "order 2", |format| format == Format::Msh),
            (self.unique_ids, "unique-ids", |format| format == Format::Msh),
        ];
        for (is_asked, option, takes) in asked {
            if is_asked && !formats.iter().copied().any(takes) {
                let known = listed(takes);
                return Err(Failure::usage(format!(
                    "--{option} is about {known}; no output is one"
                )));
            }
        }
        Ok(())
    }

    /// The name of a format as it is written, for summaries.
    pub fn name(&self, format: Format) -> String {
        let mut name = match format {
            Format::Msh => format!("Gmsh {}", word(&MSH_VERSIONS, &self.msh().version)),
            format => format.name().to_owned(),
        };
        if self.binary && format == Format::Msh {
            name.push_str(" binary");
        }
        name
    }

    fn msh(&self) -> msh::Options {
        msh::Options {
            version: self.msh_version.unwrap_or_default(),
            binary: self.binary,
            order: self.order.unwrap_or_default(),
            unique_ids: self.unique_ids,
        }
    }
}

/// What one file holds.
pub struct Content<'a> {
    pub mesh: &'a Mesh,
    pub format: Format,
    pub options: &'a WriteOptions,
    pub poly: poly::Options<'a>,
}

impl Content<'_> {
    /// Writes the file, and says what became of the mesh in it.
    pub fn write(&self, mut out: &mut dyn Write) -> io::Result<Vec<Note>> {
        let Self { mesh, options, .. } = *self;
        match self.format {
            Format::Msh => msh::write_with(mesh, options.msh(), &mut out),
            Format::Vtu => vtu::write(mesh, &mut out),
            Format::Glb => gltf::write(mesh, &mut out),
            Format::Node => node::write(mesh, &mut out),
            Format::Ele => ele::write(mesh, &mut out),
            Format::Poly => poly::write_with(mesh, self.poly, &mut out),
            Format::Edge => edge::write(mesh, &mut out),
            Format::Neigh => neigh::write(mesh, &mut out),
            Format::Geo | Format::Obj | Format::Area => {
                unreachable!("formats that hold no meshes are refused before")
            }
        }
    }
}
