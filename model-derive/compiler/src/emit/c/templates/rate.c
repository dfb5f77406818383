$number$ $name$_rate_at(const $name$_rate_t *rate, $number$ v, const $number$ q[$N$], const $number$ q_dot[$N$], $number$ psi)
{
    $number$ by_coordinates = $zero$;
    $number$ by_rates = $zero$;
    for (size_t i = 0U; i < $N$; i++) {
        by_coordinates += rate->coordinates[i] * q[i];
        by_rates += rate->rates[i] * q_dot[i];
    }
    return (v * (rate->speed + by_coordinates + (rate->heading * psi))) + by_rates;
}
