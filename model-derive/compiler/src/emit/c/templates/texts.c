$signature$
{
    static const char *const TEXTS[] = {
$texts
    };
    const size_t position = (size_t)$argument$;
    return (position < (sizeof(TEXTS) / sizeof(TEXTS[0]))) ? TEXTS[position] : $otherwise$;
}
