/**
 * The nonlinear equations of motion to first order about a state, x' = x0' + $equation$, where x are all
 * positions and then all speeds.
 *
 * Derivatives are exact, and those along motions that the conditions leave: positions that the heights of the wheels determine
 * follow the others, so a column for such a position is zero.
 */
typedef struct {
    /** The derivatives of the rates of positions and speeds, a row for each, with respect to these, a column for each. */
    $number$ a[$STATES$][$STATES$];
$by_forces
} $name$_linearization_t;

/**
 * $matrices$ about a state, which need not be one of equilibrium:
 * $count_linearize$.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
$forces_docs
 * @param[out] linearization The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t $name$_motion_linearize(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $name$_linearization_t *linearization);

/**
 * The derivatives of the rates of all positions and then of the speeds, a row for each, with respect to the parameters in
 * declared order, a column for each. Free positions, speeds and forces stay what they are, and dependent positions follow:
 * $count_by_parameters$.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
$forces_docs
 * @param[out] by_parameters The derivatives.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t $name$_motion_by_parameters(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ by_parameters[$STATES$][$PARAMETERS$]);

