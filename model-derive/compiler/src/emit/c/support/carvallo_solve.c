bool carvallo_is_finite_f64(double value)
{
    return (value >= -DBL_MAX) && (value <= DBL_MAX);
}

/* The pivot of a row relative to the largest entry of what is left of it. */
static double relative_f64(size_t size, const double m[], size_t row, size_t step)
{
    double largest = 0.0;
    for (size_t column = step; column < size; column++) {
        const double entry = fabs(m[(row * size) + column]);
        largest = (entry > largest) ? entry : largest;
    }
    return (largest > 0.0) ? (fabs(m[(row * size) + step]) / largest) : 0.0;
}

static void swap_rows_f64(double entries[], size_t columns, size_t a, size_t b)
{
    for (size_t column = 0U; column < columns; column++) {
        const double entry = entries[(a * columns) + column];
        entries[(a * columns) + column] = entries[(b * columns) + column];
        entries[(b * columns) + column] = entry;
    }
}

static size_t find_pivot_f64(size_t size, const double m[], size_t step)
{
    size_t pivot = step;
    double most = relative_f64(size, m, step, step);
    for (size_t row = step + 1U; row < size; row++) {
        const double candidate = relative_f64(size, m, row, step);
        if (candidate >= most) {
            pivot = row;
            most = candidate;
        }
    }
    return pivot;
}

/* Takes a multiple of the row of a step off every other row. */
static void eliminate_f64(size_t size, double m[], double terms[], size_t columns, double x[], size_t step)
{
    for (size_t row = 0U; row < size; row++) {
        if (row != step) {
            const double factor = m[(row * size) + step] / m[(step * size) + step];
            for (size_t column = step + 1U; column < size; column++) {
                const double product = factor * m[(step * size) + column];
                m[(row * size) + column] -= product;
                terms[(row * size) + column] += fabs(product);
            }
            for (size_t column = 0U; column < columns; column++) {
                x[(row * columns) + column] -= factor * x[(step * columns) + column];
            }
        }
    }
}

carvallo_system_error_t carvallo_solve_f64(size_t size, double m[], double terms[], size_t columns, double x[])
{
    carvallo_system_error_t error = CARVALLO_SYSTEM_OK;
    for (size_t step = 0U; step < (size * size); step++) {
        terms[step] = fabs(m[step]);
    }
    for (size_t step = 0U; (step < size) && (error == CARVALLO_SYSTEM_OK); step++) {
        const size_t pivot = find_pivot_f64(size, m, step);
        swap_rows_f64(m, size, step, pivot);
        swap_rows_f64(terms, size, step, pivot);
        swap_rows_f64(x, columns, step, pivot);
        if (fabs(m[(step * size) + step]) <= ((8.0 * DBL_EPSILON) * terms[(step * size) + step])) {
            error = CARVALLO_SYSTEM_SINGULAR_MASS;
        } else {
            eliminate_f64(size, m, terms, columns, x, step);
        }
    }
    for (size_t row = 0U; (row < size) && (error == CARVALLO_SYSTEM_OK); row++) {
        for (size_t column = 0U; column < columns; column++) {
            x[(row * columns) + column] /= m[(row * size) + row];
            if (!carvallo_is_finite_f64(x[(row * columns) + column])) {
                error = CARVALLO_SYSTEM_OUT_OF_RANGE;
            }
        }
    }
    return error;
}
