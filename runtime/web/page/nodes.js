// What is drawn, as a tree, and elements that become it. While a slider moves most of a picture stays as it is: what stays costs a
// browser nothing, where a picture that is written as text is read, styled and laid out anew in each step.

const SVG = "http://www.w3.org/2000/svg";

/** An element with its attributes, of which those without a value are left out. What is in it are elements and text, in lists of
 * any depth, where "" is nothing. */
export const tag = (name, attributes, ...content) => ({ name, attributes, content: parts(content) });

const parts = (content) => content.flat(Infinity).filter((part) => part !== "").map((part) => (typeof part === "object" ? part : { text: String(part) }));

/** What stands in each element that was filled. */
const standing = new WeakMap();

/** Makes what is in an element as it is wanted, see {@link tag}. */
export function fill(element, ...content) {
  const wanted = parts(content);
  become(element, standing.get(element) ?? [], wanted);
  standing.set(element, wanted);
}

function become(element, before, wanted) {
  wanted.forEach((part, place) => {
    const was = before[place];
    if (!was) element.append(made(part, element));
    else if (was.name !== part.name) was.node.replaceWith(made(part, element));
    else change(was, part);
  });
  before.slice(wanted.length).forEach(({ node }) => node.remove());
}

function made(part, parent) {
  const { name, text } = part;
  if (name === undefined) return (part.node = document.createTextNode(text));
  const node = document.createElementNS(name === "svg" ? SVG : parent.namespaceURI, name);
  change({ name, attributes: {}, content: [], node }, part);
  return node;
}

function change(was, part) {
  const node = (part.node = was.node);
  if (part.name === undefined) {
    if (part.text !== was.text) node.data = part.text;
    return;
  }
  for (const key in { ...was.attributes, ...part.attributes }) {
    const value = part.attributes[key];
    if (value === was.attributes[key]) continue;
    if (value === undefined) node.removeAttribute(key);
    else node.setAttribute(key, value);
  }
  become(node, was.content, part.content);
}
