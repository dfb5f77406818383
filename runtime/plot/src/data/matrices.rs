//! The matrices of a design, with their units.

use carvallo::CoordinateInfo;
use carvallo_design::Design;

/// A matrix that the model has.
pub struct Matrix {
    /// Such as `C1`.
    pub name: &'static str,
    /// Of its entries.
    pub unit: &'static str,
    /// Its entries.
    pub rows: Vec<Vec<f64>>,
}

/// The matrices that the model has, in the order of the equation.
pub fn matrices(design: &Design) -> Vec<Matrix> {
    let info = design.info();
    let all = design.equations.matrices().into_iter().filter(|(name, _)| info.matrices.contains(name));
    all.map(|(name, rows)| Matrix { name: name.name(), unit: unit(name.name(), info.coordinates), rows }).collect()
}

/// The unit of the entries of a matrix: of angles, of lengths, or of both, where each entry has its own.
fn unit(matrix: &str, coordinates: &[CoordinateInfo]) -> &'static str {
    let (lengths, angles) = match matrix {
        "M" => ("kg", "kg m²"),
        "C-1" => ("N", "N m²"),
        "C0" => ("N s/m", "N m s"),
        "C1" | "K0" => ("kg/m", "kg m"),
        "Kc" => ("N/m", "N m"),
        "K1" => ("N s/m²", "N s"),
        _ => ("kg/m²", "kg"),
    };
    if coordinates.iter().all(|coordinate| coordinate.unit == "m") {
        lengths
    } else if coordinates.iter().all(|coordinate| coordinate.unit == "rad") {
        angles
    } else {
        "SI"
    }
}

#[cfg(test)]
mod tests {
    use carvallo::CoordinateInfo;

    use super::unit;

    /// An energy is in J = kg m²/s² for any coordinates: M q'^2, Kc q^2, g K0 q^2 and (v q)^2 K2.
    #[test]
    fn units_follow_from_the_coordinates() {
        let of = |units: &[&'static str]| {
            let coordinate = |&unit| CoordinateInfo::new("q", unit);
            let coordinates: Vec<_> = units.iter().map(coordinate).collect();
            ["M", "C-1", "C0", "C1", "Kc", "K0", "K1", "K2"].map(|matrix| unit(matrix, &coordinates))
        };
        assert_eq!(of(&["rad"; 3]), ["kg m²", "N m²", "N m s", "kg m", "N m", "kg m", "N s", "kg"]);
        assert_eq!(of(&["m"]), ["kg", "N", "N s/m", "kg/m", "N/m", "kg/m", "N s/m²", "kg/m²"]);
        assert_eq!(of(&["m", "rad"]), ["SI"; 8]);
    }
}
