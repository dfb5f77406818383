/**
 * For each wheel the force of the ground on it in N, along the axes of the ground: x forward at the start, y to the right and
 * z down, so that the last component of a wheel that stands on the ground is negative. Of wheels that share an axle the
 * sideways force of the first is that of all. From one straight-line program:
 * $count_contact_forces$.
 *
 * @param[in] motion The equations.
 * @param[in] positions The positions.
 * @param[in] speeds The speeds.
$forces_docs
 * @param[out] contact_forces The forces, three numbers for each wheel, one wheel after the other.
 * @return Whether the state is singular, or something is not finite.
 */
carvallo_motion_error_t $name$_motion_contact_forces(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ contact_forces[3U * $W$]);

