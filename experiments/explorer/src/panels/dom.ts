// SPDX-License-Identifier: GPL-3.0-or-later
//
// Elements in one call each: HTML, SVG and tables.

export type Child = Node | string | null;
export type Value = string | number | boolean | ((event: Event) => void);
export type Properties = Record<string, Value>;

// Functions listen to the event of that name; true and false set or take away an attribute.
export function setProperties(element: Element, properties: Properties) {
  for (const [name, value] of Object.entries(properties)) {
    if (typeof value === 'function') element.addEventListener(name, value);
    else if (typeof value === 'boolean') element.toggleAttribute(name, value);
    else element.setAttribute(name, String(value));
  }
}

function filled<E extends Element>(element: E, properties: Properties, children: Child[]): E {
  setProperties(element, properties);
  element.append(...children.filter((child) => child !== null));
  return element;
}

export function html<K extends keyof HTMLElementTagNameMap>(
    tag: K, properties: Properties = {}, ...children: Child[]): HTMLElementTagNameMap[K] {
  return filled(document.createElement(tag), properties, children);
}

export function svg<K extends keyof SVGElementTagNameMap>(
    tag: K, properties: Properties = {}, ...children: Child[]): SVGElementTagNameMap[K] {
  return filled(document.createElementNS('http://www.w3.org/2000/svg', tag), properties, children);
}

export function button(label: string, click: () => void, properties: Properties = {}) {
  return html('button', { type: 'button', ...properties, click }, label);
}

// Only for readers that speak.
export const spoken = (text: string) => html('span', { class: 'spoken' }, text);

export type Cell = Child | Child[];

const inCell = (cell: Cell): Child[] => (Array.isArray(cell) ? cell : [cell]);

// The first cell of a row is its heading.
export function tableRow(cells: Cell[]): HTMLTableRowElement {
  return html('tr', {}, ...cells.map((cell, i) =>
    i === 0 ? html('th', { scope: 'row' }, ...inCell(cell)) : html('td', {}, ...inCell(cell))));
}

// A table whose rows are set again and again.
export class Table {
  readonly element: HTMLElement;
  private readonly head = html('tr');
  private readonly body = html('tbody');

  constructor(caption: string, head: Cell[] = []) {
    const table = html('table', {}, html('caption', { class: 'spoken' }, caption),
                       html('thead', {}, this.head), this.body);
    this.element = html('div', { class: 'wide', tabindex: 0, role: 'region', 'aria-label': caption },
                        table);
    this.setHead(head);
  }

  setHead(cells: Cell[]) {
    this.head.replaceChildren(
      ...cells.map((cell) => html('th', { scope: 'col' }, ...inCell(cell))));
  }

  setRows(rows: HTMLTableRowElement[]) {
    this.body.replaceChildren(...rows);
  }
}

// Radio buttons in a row. The value is set by show(), the reader's choice goes to `choose`.
export function choice<T extends string>(
    label: string, options: readonly (readonly [T, string])[], choose: (value: T) => void) {
  const name = `choice-${label.replace(/\W+/g, '-')}`;
  const inputs = options.map(([value]) =>
    html('input', { type: 'radio', name, value, change: () => choose(value) }));
  const element = html('fieldset', { class: 'choice' }, html('legend', {}, label),
    ...options.map(([, text], i) => html('label', {}, inputs[i]!, text)));
  const show = (value: T) => {
    options.forEach(([v], i) => { inputs[i]!.checked = v === value; });
  };
  return { element, show };
}
