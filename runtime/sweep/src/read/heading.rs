//! What the heading of a column says: a name in any spelling, and the unit of the numbers below it.

use carvallo::ModelInfo;
use carvallo_design::conventions::{Naming, folded, spelled};
use carvallo_design::quantity::{headed, is_unit};

/// A heading taken apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Heading {
    /// The name as it is known, or else as it is written.
    pub name: String,
    /// The unit of the numbers in the column.
    pub unit: Option<String>,
}

impl Heading {
    /// Of `w`, `w [mm]`, `w (mm)`, `w / mm`, `w_mm`, `Fork offset (mm)` and `fork-offset_mm`.
    pub fn parse(text: &str, info: &ModelInfo) -> Self {
        let (name, unit) = headed(text);
        if let Some(name) = spelled(name, info) {
            return Self { name, unit: unit.map(str::to_owned) };
        }
        let behind = |at: usize| {
            let unit = name[at + 1..].replace('_', "*");
            let name = spelled(&name[..at], info).filter(|_| is_unit(&unit))?;
            Some(Self { name, unit: Some(unit) })
        };
        let found = if unit.is_none() { name.match_indices('_').find_map(|(at, _)| behind(at)) } else { None };
        found.unwrap_or_else(|| Self { name: name.to_owned(), unit: unit.map(str::to_owned) })
    }
}

/// What the names mean that stand beside each other in a table. Where all are those of the model but for their case, as
/// databases fold names, and some of them are no others, they are the model's.
pub fn naming(info: &'static ModelInfo, mut headings: Vec<&mut Heading>) -> Naming {
    let names: Option<Vec<&str>> = headings.iter().map(|heading| folded(&heading.name, info)).collect();
    let is_only_folded = |heading: &&mut Heading| spelled(&heading.name, info).is_none();
    if let Some(names) = names.filter(|_| headings.iter().any(is_only_folded)) {
        headings.iter_mut().zip(names).for_each(|(heading, name)| heading.name = name.to_owned());
    }
    Naming::new(info, headings.iter().map(|heading| heading.name.as_str()))
}

#[cfg(test)]
mod tests {
    use super::Heading;
    use carvallo_design::WHIPPLE;

    #[test]
    fn headings_are_taken_apart() {
        for (text, name, unit) in [
            ("w", "w", None),
            ("w [mm]", "w", Some("mm")),
            ("I_Bxx (kg m^2)", "I_Bxx", Some("kg m^2")),
            ("lam / deg", "lam", Some("deg")),
            ("lam_deg", "lam", Some("deg")),
            ("IBxx_kg_m2", "IBxx", Some("kg*m2")),
            ("x_B", "x_B", None),
            ("m_R_kg", "m_R", Some("kg")),
            ("c [-]", "c", None),
            ("Fork offset (mm)", "fork_offset", Some("mm")),
            ("Head Angle", "head_angle", None),
            ("HEAD-ANGLE_DEG", "HEAD-ANGLE_DEG", None),
            ("head-angle_deg", "head_angle", Some("deg")),
            ("nothing_m", "nothing_m", None),
            ("d1", "d1", None),
        ] {
            let expected = Heading { name: name.to_owned(), unit: unit.map(str::to_owned) };
            assert_eq!(Heading::parse(text, WHIPPLE.info), expected, "{text}");
        }
    }
}
