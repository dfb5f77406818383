/**
 * Moves the positions that depend on the others until every wheel touches the ground, by Newton's method with bounded
 * steps. The search begins at what is given for them, so that it finds the solution that continues a motion.
 *
 * @param[in] motion The equations.
 * @param[in,out] positions The positions; unchanged on an error.
 * @return Whether no such positions are near, the state is singular, or something is not finite.
 */
carvallo_motion_error_t $name$_motion_close(const $name$_motion_t *motion, $number$ positions[$P$]);

