carvallo_system_error_t $name$_state_space(const $name$_system_t *system, $name$_state_space_t *space)
{
$tables
    carvallo_system_error_t error = CARVALLO_SYSTEM_NOT_FINITE;
    bool is_finite = true;
    $number$ m[$N$ * $N$];
    /* The columns of -K, -C and the identity matrix. */
    $number$ x[3U * $N$ * $N$];
    for (size_t row = 0U; row < $N$; row++) {
        $number$ *const solved = &x[3U * $N$ * row];
        for (size_t column = 0U; column < $N$; column++) {
            is_finite = is_finite && $finite$(system->m[row][column]) && $finite$(system->c[row][column]) && $finite$(system->k[row][column]);
            m[(row * $N$) + column] = system->m[row][column];
            solved[column] = -system->k[row][column];
            solved[$N$ + column] = -system->c[row][column];
            solved[(2U * $N$) + column] = $zero$;
        }
        solved[(2U * $N$) + row] = $one$;
$columns
    }
    if (is_finite) {
        $number$ terms[$N$ * $N$];
        error = carvallo_solve_$kind$($N$, m, terms, 3U * $N$, x);
    }
    for (size_t row = 0U; row < (2U * $N$); row++) {
        for (size_t column = 0U; column < (2U * $N$); column++) {
            space->a[row][column] = $zero$;
        }
        for (size_t column = 0U; column < $N$; column++) {
            space->b[row][column] = $zero$;
        }
    }
    if (error == CARVALLO_SYSTEM_OK) {
        for (size_t row = 0U; row < $N$; row++) {
            const size_t target = $target$;
            for (size_t column = 0U; column < (2U * $N$); column++) {
                space->a[target][column] = x[(3U * $N$ * row) + column];
            }
            for (size_t column = 0U; column < $N$; column++) {
                space->b[target][column] = x[(3U * $N$ * row) + (2U * $N$) + column];
            }
$rates
        }
    }
    return error;
}
