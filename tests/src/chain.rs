//! Declarations of chains of links that stand one on top of the other, as mechanisms.

use std::fmt::Write as _;

/// The declaration of a chain of `n` links that lean to the right about axes along x.
///
/// The parameters are those of [`crate::textbook::pendulum::Link`], link by link from the lowest, then gravity; the
/// coordinates are the angles at the hinges.
pub fn declaration(n: usize) -> String {
    let mut parameters = String::new();
    let mut mechanism = String::new();
    let mut coordinates = String::new();
    let mut below = String::from("ground");
    let mut height = String::from("0");
    // Writing to a string cannot fail.
    for link in 1..=n {
        let is_last = if link == n { ", unused" } else { "" };
        let _ = writeln!(parameters, "l{link}: m, > 0{is_last}; a{link}: m; m{link}: kg, >= 0; i{link}: kg*m^2, >= 0;");
        let _ = writeln!(
            mechanism,
            "body b{link}: mass m{link}, at (0, 0, {height} - a{link}), inertia [i{link}, 0, 0];\n\
             revolute q{link}: {below} to b{link}, through (0, 0, {height}), along (1, 0, 0);"
        );
        let _ = writeln!(coordinates, "q{link}: rad;");
        below = format!("b{link}");
        let _ = write!(height, " - l{link}");
    }
    format!(
        "model Chain {{ parameters {{ {parameters} g: N/kg, >= 0, gravity; }}\n\
         mechanism {{ {mechanism} }}\ncoordinates {{ {coordinates} }} }}"
    )
}

/// The declaration of a chain of `n` point masses on massless links, which hangs.
///
/// The parameters are the length of each link and its mass, from the highest, then gravity; the coordinates are the angles
/// at the hinges.
pub fn hanging_points(n: usize) -> String {
    let links = 1..=n;
    let list = |text: &dyn Fn(usize) -> String| links.clone().map(text).collect::<String>();
    // From the ground down to the hinge of a link.
    let depth = |link: usize| (1..link).fold(String::from("0"), |sum, above| format!("{sum} - l{above}"));
    let above = |link: usize| if link == 1 { String::from("ground") } else { format!("b{}", link - 1) };
    let parameters = list(&|link| format!("l{link}: m, > 0; m{link}: kg, > 0;\n"));
    let mechanism = list(&|link| {
        format!(
            "body b{link}: mass m{link}, at (0, 0, -({} - l{link})), inertia 0;\n\
             revolute q{link}: {} to b{link}, through (0, 0, -({})), along (1, 0, 0);\n",
            depth(link),
            above(link),
            depth(link),
        )
    });
    let coordinates = list(&|link| format!("q{link}: rad;\n"));
    format!(
        "model Points {{ parameters {{ {parameters} g: N/kg, >= 0, gravity; }}\n\
         mechanism {{ {mechanism} }}\ncoordinates {{ {coordinates} }} }}"
    )
}
