$at_speed$
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    bool is_finite = $given$;
    bool is_in_range = true;
$flag
    for (size_t row = 0U; row < $N$; row++) {
        for (size_t column = 0U; column < $N$; column++) {
$divided
            const $number$ damping = $damping$;
            const $number$ stiffness = $stiffness$;
            is_finite = is_finite$entries$;
            is_in_range = is_in_range && $finite$(damping) && $finite$(stiffness);
            system->m[row][column] = matrices->m[row][column];
            system->c[row][column] = damping;
            system->k[row][column] = stiffness;
        }
    }
    if (!is_finite) {
        error = CARVALLO_SYSTEM_NOT_FINITE;
$at_rest
    } else if (!is_in_range) {
        error = CARVALLO_SYSTEM_OUT_OF_RANGE;
    } else {
        /* All is well. */
    }
    return error;
}
