static void $name$_compute_contact_forces(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ contact_forces[3U * $W$])
{
$compute_contact_forces
}

carvallo_motion_error_t $name$_motion_contact_forces(const $name$_motion_t *motion, const $number$ positions[$P$], const $number$ speeds[$S$]$forces$, $number$ contact_forces[3U * $W$])
{
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if ($finite$(positions, $P$) && $finite$(speeds, $S$)$forces_finite$) {
        $name$_compute_contact_forces(motion, positions, speeds$pass_forces$, contact_forces);
        error = ($finite$(contact_forces, 3U * $W$)) ? CARVALLO_MOTION_OK : CARVALLO_MOTION_SINGULAR;
    }
    return error;
}
