//! The types of elements that are edges and triangles.

use crate::assembly::Shape;

/// What a type of elements is: its shape, and how many nodes it has, corners first.
pub(super) fn shape(kind: &str) -> Option<(Shape, usize)> {
    // Letters behind the number of nodes tell how stiffness is integrated.
    let stem = kind.trim_end_matches(['R', 'H', 'T', 'M', 'I', 'S', 'P', 'E']);
    Some(match stem {
        "T2D2" | "T3D2" | "B21" | "B23" | "B31" | "B33" | "R2D2" | "RAX2" | "SAX1" | "DC1D2"
        | "AC1D2" | "F2D2" => (Shape::Edge, 2),
        "T2D3" | "T3D3" | "B22" | "B32" | "SAX2" | "DC1D3" | "AC1D3" => (Shape::Edge, 3),
        "CPS3" | "CPE3" | "CPEG3" | "CAX3" | "CGAX3" | "S3" | "STRI3" | "DS3" | "M3D3" | "R3D3"
        | "SFM3D3" | "DC2D3" | "DCAX3" | "AC2D3" | "ACAX3" | "F3D3" => (Shape::Triangle, 3),
        "CPS6" | "CPE6" | "CPEG6" | "CAX6" | "CGAX6" | "S6" | "STRI65" | "DS6" | "M3D6"
        | "SFM3D6" | "DC2D6" | "DCAX6" | "AC2D6" | "ACAX6" => (Shape::Triangle, 6),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_behind_the_number_do_not_count() {
        assert_eq!(shape("S3R"), Some((Shape::Triangle, 3)));
        assert_eq!(shape("CPE6MH"), Some((Shape::Triangle, 6)));
        assert_eq!(shape("B31"), Some((Shape::Edge, 2)));
        assert_eq!(shape("C3D4"), None);
        assert_eq!(shape("S4R"), None);
    }
}
