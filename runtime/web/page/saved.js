// Designs that are kept in this browser, by their names.

const KEY = "carvallo designs";

/** All of them: files as TOML, by name. */
export function saved() {
  try {
    return JSON.parse(localStorage.getItem(KEY)) ?? {};
  } catch {
    // A browser may keep nothing for a page, or somebody has written there.
    return {};
  }
}

/** @throws {Error} if the browser keeps nothing */
export function save(name, text) {
  store({ ...saved(), [name]: text });
}

/** @throws {Error} if the browser keeps nothing */
export function forget(name) {
  const { [name]: _, ...others } = saved();
  store(others);
}

function store(designs) {
  try {
    localStorage.setItem(KEY, JSON.stringify(designs));
  } catch (error) {
    throw new Error(`this browser keeps nothing for this page (${error.message}): download the TOML file instead`);
  }
}
