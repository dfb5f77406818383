/* How far the lowest points of the wheels behind the first are below the ground, and the steps of Newton's method. */
static void $name$_compute_closure(const $name$_motion_t *motion, const $number$ positions[$P$], $number$ below[$D$], $number$ steps[$D$])
{
$compute_closure
}

carvallo_motion_error_t $name$_motion_close(const $name$_motion_t *motion, $number$ positions[$P$])
{
    /* The positions that the heights of the wheels determine. */
    static const size_t DEPENDENT[$D$] = {$dependent$};
    carvallo_motion_error_t error = CARVALLO_MOTION_NOT_FINITE;
    if ($finite$(positions, $P$)) {
        $number$ found[$P$];
        $number$ below[$D$];
        $number$ steps[$D$];
        $number$ shortest = $largest$;
        bool is_closed = false;
        bool goes_on = true;
        for (size_t i = 0U; i < $P$; i++) {
            found[i] = positions[i];
        }
        /* With steps of the greatest length they lead around the whole circle; near a solution a handful is enough. */
        for (size_t count = 0U; goes_on && (count < 60U); count++) {
            $name$_compute_closure(motion, found, below, steps);
            if ($finite$(steps, $D$)) {
                $number$ longest = $zero$;
                $number$ size = $one$;
                $number$ share = $one$;
                for (size_t i = 0U; i < $D$; i++) {
                    longest = ($absolute$(steps[i]) > longest) ? $absolute$(steps[i]) : longest;
                }
                /* No step is longer than this, in rad or m: it keeps to the solution that is near. */
                if (longest > $longest_step$) {
                    share = $longest_step$ / longest;
                }
                for (size_t i = 0U; i < $D$; i++) {
                    found[DEPENDENT[i]] += steps[i] * share;
                }
                for (size_t i = 0U; i < $D$; i++) {
                    const $number$ value = $absolute$(found[DEPENDENT[i]]);
                    size = (value > size) ? value : size;
                }
                /* Near the solution steps shrink to rounding, and then no further. */
                is_closed = (longest <= ($four$ * $epsilon$ * size)) || ((longest < $near$) && (longest >= shortest));
                goes_on = !is_closed;
                shortest = longest;
            } else {
                goes_on = false;
            }
        }
        if (is_closed) {
            error = CARVALLO_MOTION_OK;
            for (size_t i = 0U; i < $D$; i++) {
                positions[DEPENDENT[i]] = found[DEPENDENT[i]];
            }
        } else {
            $number$ most = $zero$;
            bool is_finite = false;
            $name$_compute_closure(motion, found, below, steps);
            is_finite = $one_finite$(below[0]);
            for (size_t i = 0U; i < $D$; i++) {
                if ($one_finite$(below[i]) && ($absolute$(below[i]) > most)) {
                    most = $absolute$(below[i]);
                    is_finite = true;
                }
            }
            error = is_finite ? CARVALLO_MOTION_NOT_CLOSED : CARVALLO_MOTION_SINGULAR;
        }
    }
    return error;
}
