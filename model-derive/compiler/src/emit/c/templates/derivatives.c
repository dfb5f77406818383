void $name$_with_respect_to(const $name$_derivatives_t *derivatives, size_t parameter, $name$_matrices_t *matrices)
{
    for (size_t row = 0U; row < $N$; row++) {
        for (size_t column = 0U; column < $N$; column++) {
$zeros
        }
    }
    for (size_t position = 0U; position < $count$; position++) {
        const carvallo_partial_t *const partial = &$partials$[position];
        if (partial->parameter == parameter) {
            const $number$ value = derivatives->values[partial->value];
            const $number$ signed_value = partial->is_negative ? (-value) : value;
            switch (partial->matrix) {
$cases
            default:
                /* The model has no other matrix. */
                break;
            }
        }
    }
}
