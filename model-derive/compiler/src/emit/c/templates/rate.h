/**
 * The rate of something that rolls, to first order: in rad/s for what turns and m/s for what slides.
 *
 *     v speed + rates . q' + v (coordinates . q + heading psi)
 *
 * with the forward speed v in m/s, the coordinates q, and the yaw angle psi in rad, positive to the right, where that is no
 * coordinate.
 */
typedef struct {
    /** In steady straight motion, divided by v. */
    $number$ speed;
    /** The part proportional to each q'. */
    $number$ rates[$N$];
    /** The part proportional to v and each q. */
    $number$ coordinates[$N$];
    /** The part proportional to v and the yaw. */
    $number$ heading;
} $name$_rate_t;

/**
 * A rate at a speed and a state.
 *
 * @param[in] rate The rate.
 * @param[in] v The forward speed in m/s.
 * @param[in] q The coordinates.
 * @param[in] q_dot Their rates.
 * @param[in] psi The yaw angle in rad, positive to the right, where that is no coordinate.
 * @return The rate, in rad/s or m/s.
 */
$number$ $name$_rate_at(const $name$_rate_t *rate, $number$ v, const $number$ q[$N$], const $number$ q_dot[$N$], $number$ psi);

