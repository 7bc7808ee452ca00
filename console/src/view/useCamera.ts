import { type PointerEvent, useCallback, useRef, useState } from "react";
import {
  type Aspect,
  aspects,
  type Bounds,
  type Camera,
  fit as fitted,
  type Size,
  zoom,
} from "./camera";
import { moved, noGesture, pressed, released } from "./gestures";

const first: Camera = { target: [0, 0, 0], mmPerPixel: 1, ...aspects.top };

/** The camera and what moves it. */
export function useCamera(size: Size) {
  const [camera, setCamera] = useState(first);
  const [aspect, setAspect] = useState<Aspect>("top");
  const gesture = useRef(noGesture);
  /** Somebody chose what is seen: it stays, whatever room there is. */
  const chosen = useRef(false);
  const middle = { x: size.width / 2, y: size.height / 2 };
  const look = useCallback((to: Aspect, bounds: Bounds, within: Size) => {
    chosen.current = false;
    setAspect(to);
    setCamera((now) => fitted({ ...now, ...aspects[to] }, bounds, within));
  }, []);
  /** Has a box in the picture as it is turned, so many times larger; it stays so. */
  const shows = (bounds: Bounds, margin: number) => {
    chosen.current = true;
    setCamera((now) => fitted(now, bounds, size, margin));
  };
  const zoomBy = (factor: number, x = middle.x, y = middle.y) => {
    chosen.current = true;
    setCamera((now) => zoom(now, factor, x - middle.x, y - middle.y));
  };
  const handlers = {
    onPointerDown: (event: PointerEvent) => {
      event.currentTarget.setPointerCapture(event.pointerId);
      chosen.current = true;
      const other = event.button !== 0 || event.shiftKey;
      const press = { id: event.pointerId, ...placeOf(event), other };
      gesture.current = pressed(gesture.current, press, aspect !== "solid");
    },
    onPointerMove: (event: PointerEvent) => {
      const to = placeOf(event);
      setCamera((now) => {
        const next = moved(gesture.current, now, event.pointerId, to, middle);
        gesture.current = next.gesture;
        return next.camera;
      });
    },
    onPointerUp: (event: PointerEvent) => {
      gesture.current = released(gesture.current, event.pointerId);
    },
    onPointerCancel: (event: PointerEvent) => {
      gesture.current = released(gesture.current, event.pointerId);
    },
  };
  return { camera, aspect, chosen, look, shows, zoomBy, handlers };
}

/** Place of a pointer in the element that hears it. */
function placeOf(event: PointerEvent): { x: number; y: number } {
  const box = event.currentTarget.getBoundingClientRect();
  return { x: event.clientX - box.left, y: event.clientY - box.top };
}
