/** The equations of motion M q'' + C q' + K q = f at one speed and gravity. */
typedef struct {
    /** Mass matrix M. */
    $number$ m[$N$][$N$];
    /** Damping matrix C = C-1/v + C0 + v C1. */
    $number$ c[$N$][$N$];
    /** Stiffness matrix K = Kc + g K0 + v K1 + v^2 K2. */
    $number$ k[$N$][$N$];
} $name$_system_t;

/**
 * The equations of motion$at_one_speed$.
 *
 * @param[in] matrices The coefficient matrices.
$arguments
 * @param[out] system The equations; of no use if something is wrong.
 * @return What is wrong.
 */
$at_speed$;

/**
 * The equations of motion as a system of first order, x' = A x + B f, with the state x = (q, q').
$states
 */
typedef struct {
    /** The state matrix A. */
    $number$ a[2U * $N$][2U * $N$];
    /** The input matrix B. */
    $number$ b[2U * $N$][$N$];
} $name$_state_space_t;

/**
 * The state-space form.
 *
 * @param[in] system The equations of motion.
 * @param[out] space The state-space form; zero if something is wrong.
 * @return What is wrong.
 */
carvallo_system_error_t $name$_state_space(const $name$_system_t *system, $name$_state_space_t *space);

