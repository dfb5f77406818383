/**
 * The nonlinear equations of motion with their parameters: what does not depend on the state, computed once.
 *
 * Everything is in SI units. Positions, their rates and accelerations are arrays in the order of the constants of positions,
 * speeds and their rates in that of the speeds. Positions have to be such that every wheel touches the ground; how far they
 * are from that, so far are the results. On an error what is computed is not to be used.
 */
typedef struct {
    /** In an order of their own. */
    $number$ constants[$constants$];
} $name$_motion_t;

/**
 * What does not depend on the state, from one straight-line program:
 * $count_constants$.
 *
 * @param[in] p The parameters, which are not validated.
 * @param[out] motion The equations.
 */
void $name$_motion(const $parameters$ *p, $name$_motion_t *motion);

/**
 * The rates of all positions at given speeds, of which rolling determines the others:
 * $count_rates$.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] rates The rates of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t $name$_motion_rates(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$], $number$ rates[$P$]);

/**
 * The rates of all positions and of the speeds, which is what an integration takes:
 * $count_derivatives$.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
$forces_docs
 * @param[out] rates The rates of the positions.
 * @param[out] speed_rates The rates of the speeds.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t $name$_motion_derivatives(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ rates[$P$], $number$ speed_rates[$S$]);

/**
 * The second derivatives of all positions:
 * $count_accelerations$.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
$forces_docs
 * @param[out] accelerations The accelerations of the positions.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t $name$_motion_accelerations(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ accelerations[$P$]);

/**
 * The kinetic energy, and the potential energy of gravity and springs, in J:
 * $count_energy$.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
 * @param[out] energy The kinetic energy, then the potential energy, which is zero where the centre of mass is at the
 *             height of the ground.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t $name$_motion_energy(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$], $number$ energy[2]);

