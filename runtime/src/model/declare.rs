//! The macro that declares models.

/// Declares a model by its parameters and its formulas or its mechanism, and compiles it.
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
///     assert a == m*r^2*(1 - cos(2*lam))/2;     // a claim, to be proved; also of a matrix, `assert M == [[…]];`
///     derivatives;                              // those of the matrices with respect to the parameters: see below
///
///     coordinates {
///         phi "lean": rad;                      // angles and lengths; with a direction, `rad, about x`
///     }
///
///     symmetric M = [[a + 0.1 [kg]*r^2]];       // and C-1, C0, C1, Kc, K0, K1, K2; those left out are zero
///
///     #[default]                                // at most one is: see below
///     set example "where the values come from" {
///         lam = 18 deg; m = 2; r = 35 cm; g = 9.81; I = 0;
///         M = [[0.0356]];                       // published for it: the formulas must give these digits
///     }
/// }
/// ```
///
/// The matrices are those of `M q'' + (C-1/v + C0 + v C1) q' + (Kc + g K0 + v K1 + v^2 K2) q = f`, with a row and a
/// column for each coordinate. Numbers are decimal and taken exactly: `0.5` is one half.
///
/// In the place of their parts, damping and stiffness may be written as a whole, as textbooks do, with a name for the speed
/// and with gravity in the formulas:
///
/// ```text
/// parameters { …  v: m/s, speed;  g: N/kg, >= 0, gravity; }
/// let slip = 1/v;
/// C = [[2*Cs*slip, m*v], [0, 2*Cs*l^2/v]];
/// K = [[m*g*h + k*v^2, -2*Cs], [0, 0]];
/// ```
///
/// They are sorted exactly by the powers of the speed, and an entry that is no sum of the powers that there are is refused
/// (so are `v^3` and `sqrt(v)` in `K`, and `1/v^2`). The speed is no parameter: it has no domain, no field and no value in a
/// set. `symmetric K = …` has every part proved symmetric.
///
/// A coordinate may be one of first order, as the deflection of a tyre, an actuator or a filter, whose position is a state and
/// whose rate is none: it is where its column of M is zero for all parameters. Its equation, such as `tau*F' + F = k*x`, may
/// be in any unit, and so may the coordinate itself. Or only the rate of a coordinate matters, as those of lateral and yaw
/// motion on slipping tyres: it does where its column of every stiffness matrix is zero. Both are proved, of formulas and of
/// mechanisms, so nothing need be said of them. The state is shorter then, and no eigenvalue that is always zero stands in the
/// way of a verdict. `s: m, only position;` and `psi: rad, only rate;` say it, and are held against the matrices;
/// `psi: rad, both;` keeps the position of a coordinate among the states though nothing depends on it, as one that a controller
/// measures. An equation with neither an acceleration nor the rate of a coordinate of first order is refused.
///
/// # Mechanisms
/// In the place of matrices a model may have a mechanism, from which they are derived, exactly to first order, about
/// upright straight running at a constant forward speed v, or about rest where nothing is free:
///
/// ```text
/// pub model Bicycle {
///     parameters {
///         w: m, > 0, along x;  c: m, along x;  r: m, > 0, along z;  h: m, > 0, along z;
///         lam: rad, in (-90 deg, 90 deg), about y;
///         m: kg, > 0;  I: kg*m^2, > 0;  P: kg*m^2, along x*z;  A: kg*m^2, > 0;
///         k: N/m, >= 0;  d: N*s/m, >= 0;  D: N*m*s, >= 0;  G: N*m*s, along x*z;  vG: m/s, along x;
///         g: N/kg, >= 0, gravity;
///         v: m/s, speed;
///     }
///
///     mechanism {
///         body B "rear frame": mass m, at (w/2, 0, -h), inertia [[I, 0, P], [0, I, 0], [P, 0, I]];
///         body H "front frame": massless;
///         body U "rider": mass 4*m, at (w/3, 0, -2*h), inertia [I, I, I/2];
///         body L "luggage": mass m/2, at (0, 0, -h), inertia 0;
///
///         wheel R "rear wheel" on B: mass m/9, at (0, 0, -r), radius r, axial A, radial A/2;
///         wheel F "front wheel" on H: mass m/9, at (w, 0, -r), radius r, tyre r/8, axial A, radial A/2;
///
///         free B: lean phi;
///         revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam));
///         prismatic y: B to U, along (0, 1, 0), spring k, damper d;
///         fix L to B;
///
///         force T "steer torque" on delta;
///     }
///
///     coordinates { phi "lean": rad; delta "steer": rad; y "rider": m; }
///
///     add C0 = [[D, 0, 0], [0, 0, 0], [0, 0, 0]];
///     feedback TG "steer torque of a motor" on delta = G*(1 - v/vG)*rate(phi);
/// }
/// ```
///
/// Points and directions are given in the reference configuration, where all coordinates are zero: x forward, y to the
/// right, z down, the level ground at z = 0. A quantity that no matrix depends on, as the moment of inertia in pitch of
/// a body that does not pitch, is marked `unused`.
///
/// - `body`: `mass`, its centre `at`, and `inertia` about that centre in the axes of the model, as a matrix, as
///   `[Ixx, Iyy, Izz]`, or `0` for a point mass; or `massless`. Products of inertia are entries of the matrix: xz is the
///   negative integral of x z dm. `momentum (hx, hy, hz)` (N*m*s) is that of rotors that spin in it at a constant rate, as of a
///   flywheel or an engine.
/// - `wheel`: a body of revolution that turns about an axle along y on the body that carries it, and rolls without
///   slip. `radius` is the distance from its centre to the ground; `axial` is its moment of inertia about the axle and
///   `radial` that about a diameter. It touches the ground with a knife edge, or with a `tyre` whose cross-section is a
///   circle of that radius. Two wheels on one axle are two wheels: neither slips sideways without the other.
///   A wheel with `cornering` (N by rad) slips sideways, and its tyre makes a side force against the slip angle, to the side
///   that the wheel leans to by `camber` (N by rad), `trail` (m) behind the contact point. With `relaxation` (m) the force
///   follows over that length, and `deflection` names the coordinate of first order that is the deflection of the tyre. On
///   such wheels lateral motion and yaw are coordinates, of which only the rates are states: `free B: lateral y, yaw psi`.
///   The rate of the lateral one is the velocity to the right in the axes of the body, at the origin.
///   `cornering` and `camber` may have steady loads of wheels in them, `cornering c1*load(R) - c2*load(R)^2`, in N: what each wheel
///   bears at rest, from where the masses are. What a machine shifts between its wheels as it rolls and turns changes side forces
///   only in the second order, since no tyre slips or leans while it runs straight.
/// - `revolute` and `prismatic`: a joint, called like its coordinate, from one body, or the `ground`, `to` the one that
///   it moves: right-handed about an axis `through` a point, or along it. The length of `along` is of no account.
///   `spring` (N*m or N/m) and `damper` (N*m*s or N*s/m) act on the coordinate. In the reference configuration a spring
///   at a coordinate of the model carries the weight that rests on it, any other spring is unloaded.
/// - `ball` and `planar`: joints with three freedoms, each with the name of its coordinate, and the `spring` and `damper` of a freedom
///   behind it. `ball N: A to B, through (x, y, z), yaw a, lean b, pitch c;` turns about z, x and y, each axis turned by those
///   before, as a free body does. `planar P: A to B, through (x, y, z), slides a along (1, 0, 0), slides b along (0, 0, 1), turns
///   c;` moves in a plane: the point slides along two directions of A, and B turns about it, right-handed about the first
///   direction times the second.
/// - `link`: a spring (N/m), a damper (N*s/m) or both between two points: `link S: A to B, from (x, y, z), to (x, y, z), spring
///   k, damper d;`, the first on A, the second on B, which may be the `ground`. It is unloaded in the reference configuration.
/// - `fix`: one body is a part of another one.
/// - `free`: the body on which all others hang where nothing holds it to the ground. Beside the forward motion, which
///   is v, it has the freedoms `lateral`, `vertical`, `yaw`, `lean` and `pitch`: how its point at the origin moves to
///   the right and down, and then how it turns about z, x and y (yaw and lean are positive to the right, pitch is with
///   the front up), each about an axis turned by those before. A `wheel` on no body may be free itself; then its axle
///   is its pitch. Freedoms that have a name can be coordinates; the others are what the wheels determine.
///   `forward` is what the machine moves beside its motion at the speed v: as a coordinate of its own it lets the machine speed
///   up and slow down (a pendulum on wheels). Where coordinates would do that, and it shall be left out, `hold forward;` says
///   that whatever force it takes keeps the speed, along the way of the point at the origin. That neglects what the machine would
///   speed up and slow down by, and what this would do to the coordinates in turn: as of a frame that nods on its suspension, or
///   of one whose masses are beside its middle and that yaws. Where the forward motion is light or weakly driven, make it a
///   coordinate.
/// - `force`: a force or torque that acts on a joint or freedom, positive like its coordinate; on a wheel, by its name, a torque
///   about its axle, along y, from the body that carries it.
///
/// The coordinates are joints and named freedoms, and determine all others: by the wheels, which stay on the ground and
/// do not slip. What follows beside the matrices is computed by `Name::kinematics`: the rates of all that is no
/// coordinate, yaw and wheels among them, as [`Rate`](crate::Rate)s, and `forces`, which makes f out of applied forces.
/// A joint that goes on by its own position, as a trailing caster or a trailer does, has no rate that follows from the
/// coordinates; where the motion depends on it, it is a coordinate of first order, `q: rad, only position;`.
///
/// What acts on the coordinates and is no part of a mechanism, as a drag or the inertia of a geared motor, is added to its matrices: `add C0 = [[…]];`, and so any other, each once; `add symmetric C0 = [[…]];`
/// has it proved that what is added is symmetric. The model has the sum, in its documentation, its derivatives and all
/// else, and it is the sum that assertions and published matrices are held against.
///
/// What acts on the coordinates and follows from them, as the torque of a motor, is a `feedback`: see below.
///
/// Where formulas for a matrix are known, `assert M == [[…]];` has them compared: every entry that was derived is proved
/// to be the one that is written.
///
/// What nobody has said of the bodies becomes a requirement of its own, which `validate` checks: masses and moments of
/// inertia are not negative, radii of wheels are positive, and a tyre's is at most that of its wheel. Domains that say it
/// (`m: kg, >= 0`) are enough.
///
/// Refused are a loop of joints and a body that hangs on nothing; a wheel off the ground, or without a parameter that is
/// the `gravity`; an axis of no length;
/// freedoms that nothing determines, and constraints that block or repeat each other, as with three wheels in line; a
/// reference state that gravity would leave; coordinates that change the speed in the first order; a motion that
/// depends on the position of a joint that rolls; and coordinates that move no mass.
///
/// # Feedback
/// `feedback T "what it is" on delta = -k*phi - c*v*rate(phi);` is a force or torque that follows from the motion, in a model of
/// formulas or beside or inside of a mechanism. It acts on what an applied `force` may act on: a coordinate, positive like
/// that, and in a mechanism any joint and, by its name, a wheel. On an angle it is a torque, in N m, on a length a force, in N.
///
/// It is a sum of positions and rates, each times a formula of parameters and the speed, whose name is declared by
/// `v: m/s, speed;`. The rate of `phi` is `rate(phi)`: in Rust a prime cannot stand behind a name. Exactly sorted by its powers
/// it becomes a part of C-1, C0 and C1, where rates are multiplied by 1/v, 1 and v, and of Kc, K1 and K2, where positions are by
/// 1, v and v^2, and of K0 what gravity multiplies. It stands on the right of the equation, so the matrices have it with the other
/// sign. Other powers, products of coordinates, constant forces and accelerations are refused. Claims, published matrices and
/// all else are of the matrices with feedback in them, `symmetric` included.
///
/// In a mechanism what has a name may be fed back without being a coordinate, as the yaw rate by `free B: lean phi, yaw psi;`
/// and `rate(psi)`: it is what the wheels make it. A position that they do not determine, as the heading `psi` itself, is a
/// coordinate then, of first order: `psi: rad, only position;`, and so is how far the machine is beside a line, the lateral `y`.
/// On tyres that slip a position `y` that is fed back is a place on the ground, so `y` and its rate are along the axes of the
/// ground, and no longer along those of the body. A torque on a wheel that would change the speed is refused, as anything else
/// that would, but where the forward motion is a coordinate or the speed is held.
///
/// # Nonlinear motion
/// `nonlinear;` beside a mechanism asks for its exact equations of motion, at any lean, steer and speed: see
/// [`motion`](crate::motion). They are in positions, of which the heights of the wheels determine some, and in speeds: the
/// rates of the coordinates and, of a machine on wheels, the spin of the first wheel, whose contact point with the ground
/// stands at the positions `x` and `y`. What has no name in the declaration is called `psi` (yaw), `phi` (lean), `pitch`,
/// and `theta` with the name of a wheel for its angle.
///
/// Wheels roll without slip; so a wheel with `cornering` is refused, and so are matrices that are added, `feedback`, `hold forward`,
/// links to the ground from what rolls over it, and forces on its displacements. Springs and dampers, joints and links, rotors and applied
/// forces are as for the matrices.
///
/// Together with `derivatives;` it asks for the exact derivatives of these equations as well, about any state: with respect to
/// positions, speeds and forces, and to all parameters. Positions that the heights of the wheels determine follow the others;
/// see [`Linearizable`](crate::motion::Linearizable). They take about five times the operations of the equations by state, and
/// about seven times by parameters.
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
/// a direction too: where `C-1` is written, or `C` with `1/v`, the cornering stiffness of a tyre that rolls forward is
/// `along x`. In a mechanism, which divides by the speed itself, that may be said or not. An angle and its complement mirror
/// differently, so a model with `pi/2 - lam` is written without the direction of `lam`.
///
/// # Derivatives
/// `derivatives;` asks for the exact derivatives of all entries of the matrices with respect to all parameters. They are
/// derived symbolically and optimized together with the matrices, in one program: `Name::matrices_and_derivatives`, or
/// `Name::write_matrices_and_derivatives` for where they are stored. Which
/// of them are zero for all parameters is proved, and those take neither time nor memory. A model that does not ask for
/// them pays nothing. What it asks for beside `nonlinear;` is said there.
///
/// `derivatives of M, K0 with respect to w, c;` asks for those alone, and the program computes no others; either half may be
/// left out. Of a model that asks for all matrices with respect to some parameters, `with_respect_to` gives nothing for the
/// others; of one that asks for some matrices, there is `matrix_with_respect_to` in its place. What takes any model, as
/// [`Sensitivity`](crate::Sensitivity), needs all derivatives, and so does the nonlinear motion to first order: for these such a model is one
/// without.
///
/// At valid parameters every derivative exists. A root has none where its argument is zero, so a model with derivatives
/// is refused unless domains or a `require` keep the arguments of its roots above zero.
///
/// # A function by hand
/// `compare by_hand;` names a function that has the matrices by hand, and makes a test of the crate of it: in `cargo test` both
/// run over the domains of the parameters, and where the function differs, what was done is said. It takes
/// `&Name<T>` for any [`Number`](crate::Number) T, or `&Name` alone if `: f64` stands behind it, and gives `NameMatrices` or
/// [`Coefficients`](crate::Coefficients). The crate `carvallo-compare` has to be among the `[dev-dependencies]`, and is asked
/// for in tests alone; see [`guide::comparing`](crate::guide::comparing).
///
/// # Attributes
/// Attributes of Rust before `model` are those of the struct, and before a parameter those of its field:
///
/// ```text
/// /// A point mass on a line.
/// #[derive(serde::Serialize, serde::Deserialize)]
/// #[serde(deny_unknown_fields)]
/// pub model Slider {
///     parameters {
///         #[serde(rename = "mass")]
///         m: kg, > 0;
///     }
///     coordinates { x: m; }
///     M = [[m]];
///     #[default]
///     set kilogram { m = 1; }
/// }
/// ```
///
/// `Clone`, `Copy`, `Debug` and `PartialEq` are derived for every model; a declaration may list them as well, and
/// they are derived once. What is read by serde is not validated: call `validate` then. A `cfg` belongs before
/// `carvallo::model!`. `#[default]` stands before the one parameter set, if any, that is the `Default` of the model; in a
/// model without one `#[derive(Default)]` makes all parameters zero.
///
/// # Published matrices
/// A set may carry the matrices that its source publishes. A printed entry must differ from the exact value of its
/// formula by less than one unit of its last digit; one without a decimal point is exact. Whether or not something is
/// published for it, a set is refused if a mass matrix that is declared `symmetric` is not positive definite there.
///
/// # What it proves
/// `symmetric` before a matrix claims that each entry equals its mirror image; `assert` claims that two formulas of
/// parameters and definitions are equal, or a matrix and its formulas. Claims are proved exactly, for all parameters, under the rules of fractions,
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
/// - A struct `Name<T = f64>` with the parameters as public fields, for `f32` and `f64`, which displays them with their
///   units; `Name::EXAMPLE` for each parameter set, `Name::set("example")`, and `Name::default()`; `from_array`, `to_array`, `cast`, `to_f32`,
///   and `From<Name<f32>>` for `Name<f64>`.
/// - A struct `NameMatrices<T>` with the declared matrices as [`Rows`](crate::Rows), and `Name::matrices`, which computes them
///   in one straight-line function whose documentation states its operation counts.
/// - `Name::INFO`, and [`Model<N>`](crate::Model) for `Name<T>`: names, units, domains, validation, conversion from and to slices, and the
///   matrices as [`Coefficients`](crate::Coefficients).
/// - With `derivatives` a struct `NameDerivatives<T>`, `Name::matrices_and_derivatives` and
///   `Name::write_matrices_and_derivatives`: an array of the values of the
///   derivatives that are not zero for all parameters, each once, the table `NameDerivatives::PARTIALS` that says which
///   derivatives have them, and `with_respect_to` for all matrices derived with respect to one parameter; and if all are asked for
///   [`Differentiable<N>`](crate::Differentiable), with all of them as [`Coefficients`](crate::Coefficients).
/// - With `nonlinear;` a struct `NameMotion<T>` with [`Motion`](crate::Motion), and `Name::motion`, which computes what does
///   not depend on the state; and [`Nonlinear<N>`](crate::Nonlinear). With `derivatives;` as well it has
///   [`Linearizable`](crate::motion::Linearizable).
/// - For a mechanism a struct `NameKinematics<T>` and `Name::kinematics`, if anything moves or acts beside the coordinates.
///
/// A model whose structs have the names of something else in their module is one error, at its name, where that stands
/// in the same file under no `cfg` and in no other macro's call; else it is many, each of which rustc makes of it.
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
