//! Tasks that the emitted C does: to the same bits as the Rust, which the host computes.

use carvallo::Model;
use carvallo_models::Whipple;
use tasks::Task;

type Rows<T> = [[T; 2]; 2];

/// `whipple_f64_t` and `whipple_f32_t`, whose members are the parameters in declared order.
type Parameters<T> = <Whipple<T> as Model<2>>::Array<T>;

/// `whipple_f64_matrices_t` and `whipple_f32_matrices_t`: M, C1, K0 and K2.
type Matrices<T> = [Rows<T>; 4];

/// `whipple_f64_system_t` and `whipple_f32_system_t`: M, C and K.
type System<T> = [Rows<T>; 3];

/// `whipple_f64_state_space_t` and `whipple_f32_state_space_t`.
#[repr(C)]
#[derive(Default)]
pub struct StateSpace<T> {
    a: [[T; 4]; 4],
    b: [[T; 2]; 4],
}

macro_rules! tasks_in_c {
    ($T:ident, $Matrices:ident, $StateSpace:ident, $matrices:ident, $at_speed:ident, $state_space:ident, $names:expr) => {
        unsafe extern "C" {
            fn $matrices(parameters: *const Parameters<$T>, matrices: *mut Matrices<$T>);
            fn $at_speed(matrices: *const Matrices<$T>, speed: $T, gravity: $T, system: *mut System<$T>) -> u32;
            fn $state_space(system: *const System<$T>, space: *mut StateSpace<$T>) -> u32;
        }

        /// The four matrices, from the parameters.
        pub struct $Matrices;

        impl Task for $Matrices {
            const NAME: &'static str = $names[0];
            type Input = Parameters<$T>;
            type Output = Matrices<$T>;
            fn input() -> Self::Input {
                tasks::$Matrices::input().parameters()
            }
            fn run(parameters: &Self::Input) -> Self::Output {
                let mut matrices = Matrices::default();
                // SAFETY: both are of the layout that the function expects, as their types say.
                unsafe { $matrices(parameters, &mut matrices) };
                matrices
            }
            fn bits(matrices: &Self::Output, tell: &mut dyn FnMut(u64)) {
                matrices.iter().flatten().flatten().for_each(|entry| tell(entry.to_bits().into()));
            }
        }

        /// The state-space form at a speed, from the matrices.
        pub struct $StateSpace;

        impl Task for $StateSpace {
            const NAME: &'static str = $names[1];
            type Input = Matrices<$T>;
            type Output = StateSpace<$T>;
            fn input() -> Self::Input {
                $Matrices::run(&$Matrices::input())
            }
            fn run(matrices: &Self::Input) -> Self::Output {
                let (mut system, mut space) = (System::default(), StateSpace::default());
                // SAFETY: as above. What is wrong is told by zeros, which are not what the host expects.
                unsafe {
                    if $at_speed(matrices, tasks::SPEED as $T, tasks::GRAVITY as $T, &mut system) == 0 {
                        $state_space(&system, &mut space);
                    }
                }
                space
            }
            /// Block by block and column by column, as the Rust keeps them.
            fn bits(space: &Self::Output, tell: &mut dyn FnMut(u64)) {
                let [.., lean, steer] = &space.a;
                lean.iter().zip(steer).for_each(|(x, y)| [x, y].iter().for_each(|entry| tell(entry.to_bits().into())));
                let [.., lean, steer] = &space.b;
                lean.iter().zip(steer).for_each(|(x, y)| [x, y].iter().for_each(|entry| tell(entry.to_bits().into())));
            }
        }
    };
}

tasks_in_c!(
    f32,
    MatricesF32,
    StateSpaceF32,
    whipple_f32_matrices,
    whipple_f32_at_speed,
    whipple_f32_state_space,
    ["c_matrices_f32", "c_state_space_f32"]
);
tasks_in_c!(
    f64,
    MatricesF64,
    StateSpaceF64,
    whipple_f64_matrices,
    whipple_f64_at_speed,
    whipple_f64_state_space,
    ["c_matrices_f64", "c_state_space_f64"]
);
