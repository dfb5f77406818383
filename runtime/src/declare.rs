//! The macro that declares models.

/// Declares a model by its parameters and formulas, and compiles it.
///
/// ```text
/// /// Documentation of the model.
/// pub model Name {
///     source "where the formulas come from";
///
///     parameters {
///         /// Documentation, then: name, symbol, unit, domain.
///         lam "λ": rad, in (-90 deg, 90 deg);   // an open interval; `in [a, b]` includes its ends
///         m: kg, > 0;                           // or `>=`, `<`, `<=`, `!= 0`; without one any finite value
///         r: m, > 0, along z;                   // how it lies in the axes: see below
///         g: N/kg, >= 0, gravity;               // the field strength that K0 is multiplied by
///         I: kg*m^2, >= 0, unused;              // no matrix depends on it
///     }
///
///     let a = m*r^2*sin(lam)^2;                 // + - * / ^, parentheses, sin, cos, tan, sqrt, pi
///     require a/r^2 + m > 0;                    // a condition on several parameters; `!= 0` is one too
///     assert a == m*r^2*(1 - cos(2*lam))/2;     // a claim, to be proved
///
///     coordinates {
///         phi "lean": rad;                      // angles and lengths; with a direction, `rad, about x`
///     }
///
///     symmetric M = [[a + 0.1 [kg]*r^2]];       // and C0, C1, Kc, K0, K2: those left out are zero
///
///     set example "where the values come from" {
///         lam = 18 deg; m = 2; r = 35 cm; g = 9.81; I = 0;
///         M = [[0.0356]];                       // published for it: the formulas must give these digits
///     }
/// }
/// ```
///
/// The matrices are those of `M q'' + (C0 + v C1) q' + (Kc + g K0 + v^2 K2) q = f`, with a row and a column for each
/// coordinate. Numbers are decimal and taken exactly: `0.5` is one half.
///
/// # Units
/// Every formula is analysed: the terms of a sum are in one unit, `sin`, `cos` and `tan` take pure numbers, and each
/// entry of a matrix is in the unit that follows from the coordinates of its row and column, which are angles or lengths:
/// kg m² for M, kg m for C1 and K0, kg for K2 where both are angles. Formulas calculate in `kg`, `m`, `s`, `rad`, `N`, `J`,
/// `W`, `Pa`, `Hz` and their products and powers (`kg*m^2`, `N/(m/s)`), so parameters are in them. Values may also be given
/// in `deg`, `g`, `t`, `mm`, `cm`, `km`, `ms`, `min`, `h`, `kN` and `kPa`; without a unit they are in that of their
/// parameter. A number in a formula is a pure number unless a unit follows in brackets: `0.3 [m]`; equations that were made
/// dimensionless need one such factor, `1 [kg]`, in each entry.
///
/// # Mirrors
/// Axes are x forward, y to the right, z down. Equations of motion hold in mirrored axes as well, with mirrored
/// parameters: so where one term of a sum changes its sign, all do. To have that checked, say which parameters and
/// coordinates change theirs: lengths `along x`, `along y` or `along z` with the mirror of that axis; angles `about x`,
/// `about y` or `about z` with those of the two others; products of inertia `along x*z` with both. What says nothing keeps
/// its sign. The check is on in models in which at least one quantity has a direction. It finds a height in the place of a
/// length and a sine in the place of a cosine, which units cannot tell apart. Speeds and whatever is defined with one have
/// a direction too: the cornering stiffness of a tyre that rolls forward is `along x`. An angle and its complement mirror
/// differently, so a model with `pi/2 - lam` is written without the direction of `lam`.
///
/// # Published matrices
/// A set may carry the matrices that its source publishes. A printed entry must differ from the exact value of its
/// formula by less than one unit of its last digit; one without a decimal point is exact. Whether or not something is
/// published for it, a set is refused if a mass matrix that is declared `symmetric` is not positive definite there.
///
/// # What it proves
/// `symmetric` before a matrix claims that each entry equals its mirror image; `assert` claims that two formulas of
/// parameters and definitions are equal. Claims are proved exactly, for all parameters, under the rules of fractions,
/// roots, sin² + cos² = 1 and the addition theorems, but without the domains: `sqrt(a^2) == a` is not proved for a > 0.
/// One that is wrong is an error with values for which it is, inside the domains and requirements; so is one that can be
/// neither proved nor refuted. Claims make no code, and what only they mention is not used.
///
/// Everything that a formula divides by, the cosine in a tangent, and everything under a root is bounded over the
/// declared domains. What they and the requirements do not keep from zero, or a root's argument from being negative,
/// becomes a requirement of its own: `validate` refuses it and names it, and so does the documentation of
/// `Name::matrices`. A `require` on the expression, or on a power of two times it, says it in your words.
///
/// # What it makes
/// - A struct `Name<T = f64>` with the parameters as public fields, for `f32` and `f64`; `Name::EXAMPLE` for each
///   parameter set; `from_array`, `to_array`, `cast`.
/// - A struct `NameMatrices<T>` with the declared matrices as arrays of rows, and `Name::matrices`, which computes them
///   in one straight-line function whose documentation states its operation counts.
/// - [`Model<N>`](crate::Model) for `Name<T>`: names, units, domains, validation, conversion from and to slices, and the
///   matrices as [`Coefficients`](crate::Coefficients).
///
/// The code needs no `std`, allocates nothing and has no `unsafe`.
///
/// # Errors
/// All mistakes of a declaration are reported at once, each where it is, with what was expected; claims, divisions and
/// what sets publish are looked at once nothing else is wrong.
#[macro_export]
macro_rules! model {
    ($($declaration:tt)*) => {
        $crate::__model! { ($crate) $($declaration)* }
    };
}
