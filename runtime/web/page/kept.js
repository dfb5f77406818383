// Answers that are kept, since most of what is asked for in a step was asked for in the one before.

/** A function that answers questions, with the last answers kept by what was asked. */
export function kept(most, answer) {
  const cache = new Map();
  return (question) => {
    const key = JSON.stringify(question);
    const found = cache.get(key) ?? answer(question);
    // The one that was asked for last leaves last.
    cache.delete(key);
    cache.set(key, found);
    if (cache.size > most) cache.delete(cache.keys().next().value);
    return found;
  };
}
