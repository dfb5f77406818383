void $name$_motion(const $parameters$ *p, $name$_motion_t *motion)
{
$compute_constants
}

static void $name$_compute_rates(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$], $number$ rates[$P$])
{
$compute_rates
}

carvallo_motion_error_t $name$_motion_rates(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$], $number$ rates[$P$])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if ($finite$(positions, $P$) && $finite$(speeds, $S$)) {
        $name$_compute_rates(motion, positions, speeds, rates);
        error = ($finite$(rates, $P$)) ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void $name$_compute_derivatives(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ rates[$P$], $number$ speed_rates[$S$])
{
$compute_derivatives
}

carvallo_motion_error_t $name$_motion_derivatives(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ rates[$P$], $number$ speed_rates[$S$])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if ($finite$(positions, $P$) && $finite$(speeds, $S$)$forces_finite$) {
        $name$_compute_derivatives(motion, positions, speeds$pass_forces$, rates, speed_rates);
        error = ($finite$(rates, $P$) && $finite$(speed_rates, $S$)) ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void $name$_compute_accelerations(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ accelerations[$P$])
{
$compute_accelerations
}

carvallo_motion_error_t $name$_motion_accelerations(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ accelerations[$P$])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if ($finite$(positions, $P$) && $finite$(speeds, $S$)$forces_finite$) {
        $name$_compute_accelerations(motion, positions, speeds$pass_forces$, accelerations);
        error = ($finite$(accelerations, $P$)) ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}

static void $name$_compute_energy(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$], $number$ energy[2])
{
$compute_energy
}

carvallo_motion_error_t $name$_motion_energy(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$], $number$ energy[2])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if ($finite$(positions, $P$) && $finite$(speeds, $S$)) {
        $name$_compute_energy(motion, positions, speeds, energy);
        error = ($finite$(energy, 2U)) ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
