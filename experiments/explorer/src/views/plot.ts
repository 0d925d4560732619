// SPDX-License-Identifier: GPL-3.0-or-later
//
// One plot of one space: a canvas, and the three vertices as handles that are dragged by a pointer
// and moved by keys. Elsewhere a drag turns (or shifts) the plot, wheel and pinch zoom, a double
// click fits it again.

import type { Page } from '../panel';
import type { Scene } from '../scene';
import { kLetters, type State } from '../state';
import { dragged, nudged, withVertex, type Held } from './drag';
import { drawFigure } from './figure';
import { onLayers } from './layers';
import { project, type Lens, type Pixel } from './lens';
import { Painter } from './painter';
import { pointOf, type Space } from './space';
import { colours, onColours } from './theme';

const kInset = 12; // of the handles of vertices that are not on the canvas, from its border

const kCanvasHelp = 'Arrow keys turn it, plus and minus zoom, 0 fits it.';
const kVertexHelp =
  'Arrow keys and page up and down move it, with shift by one unit in the last place.';

export class Plot {
  readonly root = document.createElement('div');
  private readonly canvas = document.createElement('canvas');
  private readonly handles: HTMLElement[];
  private readonly painter = new Painter(this.canvas);
  private readonly lens: Lens;
  private scene: Scene | null = null;
  private held: Held | null = null;
  private holder = -1; // the pointer that holds it
  private withShift = false;
  private readonly pointers = new Map<number, Pixel>();
  private isWaiting = false;
  private isFitted = false;
  private isShown = false;
  private isTurned = false; // by the reader, who then has the last word

  constructor(private readonly space: Space, private readonly page: Page) {
    this.lens = space.makeLens();
    this.root.className = 'plot';
    this.root.dataset.space = space.id;
    this.canvas.tabIndex = 0;
    this.canvas.setAttribute('role', 'application');
    this.canvas.setAttribute('aria-label', `Picture of ${space.label}. ${kCanvasHelp}`);
    this.handles = kLetters.map((letter, i) => this.handle(letter, i));
    this.root.append(this.canvas, ...this.handles);
    this.listen();
    new ResizeObserver(([entry]) => {
      this.resize(entry!.contentRect.width, entry!.contentRect.height);
    }).observe(this.root);
    onColours(() => this.redraw());
    onLayers(() => this.redraw());
  }

  show(scene: Scene) {
    if (this.scene !== null) this.follow(scene.state, this.scene.state);
    this.scene = scene;
    this.draw();
  }

  // Another triangle is fitted; what the reader has turned stays when only the volume changes.
  private follow(state: State, before: State) {
    if (isOther(state, before)) this.isTurned = false;
    else if (this.isTurned || !isReshaped(state, before)) return;
    this.isFitted = false;
  }

  private handle(letter: string, vertex: number): HTMLElement {
    const handle = document.createElement('div');
    handle.className = 'vertex';
    handle.tabIndex = 0;
    handle.textContent = letter;
    handle.setAttribute('role', 'slider');
    handle.setAttribute('aria-valuemin', '-1e30');
    handle.setAttribute('aria-valuemax', '1e30');
    handle.setAttribute('aria-label', `${letter} in ${this.space.label}`);
    handle.setAttribute('aria-description', kVertexHelp);
    handle.addEventListener('focus', () => this.page.store.update({ selected: vertex }));
    handle.addEventListener('keydown', (event) => this.keyOnVertex(event, vertex));
    return handle;
  }

  private listen() {
    const { root } = this;
    root.addEventListener('pointerdown', (event) => this.down(event));
    root.addEventListener('pointermove', (event) => this.moved(event));
    for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
      root.addEventListener(end, (event) => this.up(event));
    }
    root.addEventListener('wheel', (event) => {
      event.preventDefault();
      this.lens.zoom(Math.exp(-event.deltaY * (event.deltaMode === 1 ? 0.05 : 0.0015)),
                     this.pixel(event));
      this.turned();
    }, { passive: false });
    root.addEventListener('dblclick', () => this.fit());
    this.canvas.addEventListener('keydown', (event) => this.keyOnCanvas(event));
  }

  private pixel(event: MouseEvent): Pixel {
    const { left, top } = this.canvas.getBoundingClientRect();
    return { x: event.clientX - left, y: event.clientY - top };
  }

  private down(event: PointerEvent) {
    if (event.button !== 0) return;
    const pixel = this.pixel(event);
    this.pointers.set(event.pointerId, pixel);
    this.root.setPointerCapture(event.pointerId);
    const vertex = this.handles.indexOf(event.target as HTMLElement);
    if (vertex < 0 || this.held !== null) return;
    this.holder = event.pointerId;
    this.hold(vertex, pixel, event.shiftKey);
    this.root.classList.add('dragging');
    // The handle keeps the focus that the capture would take from it.
    event.preventDefault();
    this.handles[vertex]!.focus({ preventScroll: true });
  }

  // In a plane there is no view axis to move along.
  private hold(vertex: number, pixel: Pixel, withShift: boolean) {
    const isAlongAxis = withShift && this.lens.axes().away !== null;
    const scene = this.scene!;
    const point = pointOf(this.space, scene, vertex);
    if (point === null) return;
    const at = project(this.lens, [...point, 1]);
    // A vertex that is not on the canvas comes under the pointer when it is taken.
    const isNear = Math.hypot(pixel.x - at.x, pixel.y - at.y) < 40;
    const isThere = at.w > 0 && (isNear || this.held !== null);
    const grab = isThere ? { x: pixel.x - at.x, y: pixel.y - at.y } : { x: 0, y: 0 };
    const numbers = scene.state.triangle[vertex]!.position;
    this.held = { vertex, numbers, point, pixel, grab, isAlongAxis };
    this.withShift = withShift;
  }

  private moved(event: PointerEvent) {
    const before = this.pointers.get(event.pointerId);
    if (before === undefined) return;
    const pixel = this.pixel(event);
    if (this.held !== null) {
      if (event.pointerId === this.holder) this.drag(pixel, event);
    } else {
      if (this.pointers.size > 1) this.pinch(event.pointerId, before, pixel);
      else this.lens.turn(pixel.x - before.x, pixel.y - before.y);
      this.turned();
    }
    this.pointers.set(event.pointerId, pixel);
  }

  private drag(pixel: Pixel, event: PointerEvent) {
    if (this.withShift !== event.shiftKey) {
      this.hold(this.held!.vertex, pixel, event.shiftKey);
    }
    const held = this.held!;
    const { state } = this.page.store;
    const moved = dragged(this.space, this.scene!, this.lens, held, pixel, !event.altKey);
    if (moved !== null) this.page.store.update(withVertex(state, held.vertex, moved.numbers));
  }

  private pinch(id: number, before: Pixel, after: Pixel) {
    const other = [...this.pointers].find(([key]) => key !== id)![1];
    const gap = (p: Pixel) => Math.max(1, Math.hypot(p.x - other.x, p.y - other.y));
    this.lens.zoom(gap(after) / gap(before),
                   { x: (after.x + other.x) / 2, y: (after.y + other.y) / 2 });
  }

  private up(event: PointerEvent) {
    this.pointers.delete(event.pointerId);
    if (event.pointerId !== this.holder) return;
    this.held = null;
    this.holder = -1;
    this.root.classList.remove('dragging');
  }

  private keyOnVertex(event: KeyboardEvent, vertex: number) {
    if (event.ctrlKey || event.metaKey || event.altKey || this.scene === null) return;
    const numbers = nudged(this.space, this.scene, this.lens, vertex, event.key, event.shiftKey);
    if (numbers === undefined) return;
    event.preventDefault();
    const { store } = this.page;
    if (numbers !== null) store.update(withVertex(store.state, vertex, numbers));
  }

  private keyOnCanvas(event: KeyboardEvent) {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const middle = { x: this.painter.width / 2, y: this.painter.height / 2 };
    const turns: Record<string, [number, number]> =
      { ArrowLeft: [-20, 0], ArrowRight: [20, 0], ArrowUp: [0, -20], ArrowDown: [0, 20] };
    const zooms: Record<string, number> = { '+': 1.2, '=': 1.2, '-': 1 / 1.2 };
    const turn = turns[event.key], zoom = zooms[event.key];
    if (turn === undefined && zoom === undefined && event.key !== '0') return;
    event.preventDefault();
    if (event.key === '0') { this.fit(); return; }
    if (turn !== undefined) this.lens.turn(...turn);
    if (zoom !== undefined) this.lens.zoom(zoom, middle);
    this.turned();
  }

  private turned() {
    this.isTurned = true;
    this.redraw();
  }

  private fit() {
    this.isFitted = this.isTurned = false;
    this.redraw();
  }

  // Sizes come from the observer alone: to ask for them in draw() would lay out the page each time.
  private resize(width: number, height: number) {
    this.isShown = width > 0 && height > 0;
    if (!this.isShown) return;
    this.painter.resize(width, height);
    this.lens.resize(width, height);
    if (!this.isTurned) this.isFitted = false;
    this.draw(); // at once: a canvas that changes its size is empty
  }

  private redraw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.draw();
    });
  }

  private draw() {
    if (this.scene === null || !this.isShown) return;
    if (!this.isFitted) this.lens.fit(this.space.landmarks(this.scene));
    this.isFitted = true;
    const canvas = { painter: this.painter, lens: this.lens, colours: colours() };
    this.painter.begin(this.lens);
    this.space.drawVolume(this.scene, canvas);
    drawFigure(this.space, this.scene, canvas);
    this.handles.forEach((handle, i) => this.placeHandle(handle, i));
  }

  private placeHandle(handle: HTMLElement, vertex: number) {
    const scene = this.scene!;
    const point = pointOf(this.space, scene, vertex);
    const words = this.space.values(scene, vertex);
    if (handle.getAttribute('aria-valuetext') !== words) {
      handle.setAttribute('aria-valuetext', words);
      handle.setAttribute('aria-valuenow', String(point?.[this.lens.axes().right.index] ?? 0));
    }
    handle.classList.toggle('selected', vertex === scene.state.selected);
    handle.classList.toggle('nowhere', point === null);
    if (point === null) return;
    const { x, y, w } = project(this.lens, [...point, 1]);
    const { width, height } = this.painter;
    // Behind the viewer the image is upside down; the handle stands on the side where it would be.
    const sign = w > 0 ? 1 : -1e6;
    const dx = sign * (x - width / 2), dy = sign * (y - height / 2);
    const room = { x: width / 2 - kInset, y: height / 2 - kInset };
    const shrink = Math.min(1, room.x / Math.abs(dx), room.y / Math.abs(dy));
    handle.classList.toggle('away', shrink < 1);
    handle.style.setProperty('--towards', `${Math.atan2(dy, dx)}rad`);
    handle.style.transform =
      `translate(${width / 2 + dx * shrink}px, ${height / 2 + dy * shrink}px)`;
  }
}

// Another triangle, not a vertex of this one that was moved: at least two vertices are new.
function isOther(state: State, before: State): boolean {
  const changed = state.triangle.filter(
    (v, i) => v.position.some((n, k) => n !== before.triangle[i]!.position[k]));
  return state.source !== before.source ||
         (state.space === before.space && changed.length >= 2);
}

function isReshaped({ frustum: f }: State, { frustum: before }: State): boolean {
  return f.parallel !== before.parallel || f.depth !== before.depth;
}
