static void $name$_compute_linearization(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $name$_linearization_t *linearization)
{
$compute_linearization
}

carvallo_motion_error_t $name$_motion_linearize(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $name$_linearization_t *linearization)
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if ($finite$(positions, $P$) && $finite$(speeds, $S$)$forces_finite$) {
        bool are_finite = true;
        $name$_compute_linearization(motion, positions, speeds$pass_forces$, linearization);
        for (size_t row = 0U; row < $STATES$; row++) {
            are_finite = are_finite && $finite$(linearization->a[row], $STATES$)$b_finite$;
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void $name$_compute_by_parameters(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ by_parameters[$STATES$][$PARAMETERS$])
{
$compute_by_parameters
}

carvallo_motion_error_t $name$_motion_by_parameters(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ by_parameters[$STATES$][$PARAMETERS$])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if ($finite$(positions, $P$) && $finite$(speeds, $S$)$forces_finite$) {
        bool are_finite = true;
        $name$_compute_by_parameters(motion, positions, speeds$pass_forces$, by_parameters);
        for (size_t row = 0U; row < $STATES$; row++) {
            are_finite = are_finite && $finite$(by_parameters[row], $PARAMETERS$);
        }
        error = are_finite ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
