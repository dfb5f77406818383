//! The equations of models as text, LaTeX and Typst.

use crate::Directory;

fn run(arguments: &[&str]) -> String {
    Directory::of_this_test().run(&[&["equations"], arguments].concat()).ok()
}

#[test]
fn text_has_definitions_entries_and_units() {
    let text = run(&["pendulum"]);
    let expected =
        "M q'' + C0 q' + g K0 q = f, q = (theta)\n\nM_11 = m*l^2 [kg*m^2]\nC0_11 = c [kg*m^2/s]\nK0_11 = m*l [kg*m]\n";
    assert_eq!(text, expected);
    let text = run(&[]);
    assert!(
        text.starts_with("M q'' + v C1 q' + (g K0 + v^2 K2) q = f, q = (phi, delta)\n\nmT = mR + mB + mH + mF [kg]\n")
    );
    assert!(text.ends_with("\nK2_22 = ((SA + SF*sin(lam))/w)*cos(lam) [kg]\n"), "{text}");
}

#[test]
fn latex_has_symbols_fractions_and_units() {
    let text = run(&["--format", "latex"]);
    for expected in [
        "  M \\ddot{q} + v C_1 \\dot{q} + (g K_0 + v^2 K_2) q = f, \\quad q = (\\phi, \\delta)\n",
        "  \\mu &= \\frac{c}{w} \\cos \\lambda \\\\\n",
        "  S_R &= \\frac{I_{Ryy}}{r_R} &\\quad& [\\mathrm{kg\\,m}] \\\\\n",
        "  M_{12} = M_{21} &= I_{Alx} + \\mu I_{Txz} &\\quad& [\\mathrm{kg\\,m^{2}}] \\\\\n",
        "  K_{2,22} &= \\frac{S_A + S_F \\sin \\lambda}{w} \\cos \\lambda &\\quad& [\\mathrm{kg}]\n\\end{align*}\n",
    ] {
        assert!(text.contains(expected), "{expected} is not in\n{text}");
    }
    assert_eq!(text.matches("\\begin").count(), text.matches("\\end").count());
}

#[test]
fn typst_has_symbols_fractions_and_units() {
    let text = run(&["WHIPPLE", "--format", "typst"]);
    for expected in [
        "#show math.equation: set block(breakable: true)\n$ M dot.double(q) + v C_1 dot(q) + (g K_0 + v^2 K_2) q = f, quad q = (phi, delta) $\n",
        "  mu & = frac(c, w) cos lambda \\\n",
        "  S_R & = frac(I_(R y y), r_R) & quad & [\"kg\" thin \"m\"] \\\n",
        "  M_12 = M_21 & = I_(A l x) + mu I_(T x z) & quad & [\"kg\" thin \"m\"^2] \\\n",
    ] {
        assert!(text.contains(expected), "{expected} is not in\n{text}");
    }
}

#[test]
fn unknown_models_and_formats_are_refused() {
    let directory = Directory::of_this_test();
    let run = directory.run(&["equations", "Wipple"]);
    assert_eq!(run.code, Some(2));
    assert!(run.stderr.contains("there is no model `Wipple`; did you mean `Whipple`?"), "{}", run.stderr);
    assert_eq!(directory.run(&["equations", "--format", "word"]).code, Some(2));
}
