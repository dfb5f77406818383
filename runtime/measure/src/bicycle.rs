//! The parameters of a bicycle from all that was measured of it.

use carvallo::Uncertain;
use carvallo_design::joined::Inertia;

use crate::geometry::{Geometry, handlebar};
use crate::part::measured;
use crate::pendulum::{Torsion, compound};
use crate::table::Table;

/// Names and values, as the model of the paper has them.
pub fn parameters<'a>(table: &Table<'a>) -> Vec<(&'static str, Uncertain<'a>)> {
    let Geometry { w, c, lam, r_r, r_f } = Geometry::of(table);
    let torsion = Torsion::of(table);
    let wheel = |letter: char| {
        let of = |name: &str| table.get(&format!("{name}{letter}"));
        let mass = of("m");
        let axial = compound(table, mass, of("l"), table.get(&format!("Tc{letter}1")));
        [mass, torsion.moment(table.get(&format!("Tt{letter}1"))), axial]
    };
    let ([m_r, ir_xx, ir_yy], [m_f, if_xx, if_yy]) = (wheel('R'), wheel('F'));
    let rear = measured(table, 'B', torsion, lam, [table.exact(0.0), -r_r]);
    let front = front_frame(table, torsion, lam, [w, -r_f]);
    vec![
        ("w", w),
        ("c", c),
        ("lam", lam),
        ("g", table.get("g")),
        ("rR", r_r),
        ("mR", m_r),
        ("IRxx", ir_xx),
        ("IRyy", ir_yy),
        ("xB", rear.x),
        ("zB", rear.z),
        ("mB", rear.mass),
        ("IBxx", rear.xx),
        ("IByy", rear.yy),
        ("IBzz", rear.zz),
        ("IBxz", rear.xz),
        ("xH", front.x),
        ("zH", front.z),
        ("mH", front.mass),
        ("IHxx", front.xx),
        ("IHyy", front.yy),
        ("IHzz", front.zz),
        ("IHxz", front.xz),
        ("rF", r_f),
        ("mF", m_f),
        ("IFxx", if_xx),
        ("IFyy", if_yy),
    ]
}

/// The fork with its handlebar, measured as one, H, or as two, S and G.
fn front_frame<'a>(
    table: &Table<'a>,
    torsion: Torsion<'a>,
    lam: Uncertain<'a>,
    [x, z]: [Uncertain<'a>; 2],
) -> Inertia<'a> {
    if !table.is_fork_split() {
        return measured(table, 'H', torsion, lam, [x, z]);
    }
    let [behind, above] = handlebar(table, lam);
    let fork = measured(table, 'S', torsion, lam, [x, z]);
    fork.with(measured(table, 'G', torsion, lam, [x - behind, z - above]))
}
