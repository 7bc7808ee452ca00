/** Small pictures of what the tools do, 16 by 16. */

const paths: Record<string, string> = {
  line: "M2 13 6 4 10 10 14 3",
  polyarc: "M2 13C2 6 8 4 9 9s5 2 5-5",
  rectangle: "M2.5 4h11v8h-11z",
  circle: "M8 2.5a5.5 5.5 0 1 0 .01 0",
  point: "M8 3v10M3 8h10M8 6a2 2 0 1 0 .01 0",
  erase: "M3 3l10 10M13 3 3 13",
  fillet: "M2 3h6a6 6 0 0 1 6 6v5",
  chamfer: "M2 3h7l5 5v6",
  offset: "M2 5h9v9M5 8h3v3",
  join: "M1 12 6 7M10 9l5-5M6 7l4 2",
  break: "M1 12l5-4M10 8l5-4M7 5v6",
  trim: "M2 2v12M14 2v12M2 8h3M11 8h3",
  stretch: "M2 4h7v8H2zM10 8h5M13 6l2 2-2 2",
  vertex: "M2 13 8 5l6 8M6.5 3.500h3v3h-3z",
  "delete-vertex": "M2 13 8 6l6 7M6 2l4 4M10 2 6 6",
  bulge: "M2 12Q8 -2 14 12",
  move: "M8 1v14M1 8h14M6 3l2-2 2 2M6 13l2 2 2-2M3 6 1 8l2 2M13 6l2 2-2 2",
  copy: "M2 5h8v9H2zM6 5V2h8v9h-4",
  rotate: "M13 8a5 5 0 1 1-2-4M11 1v3h-3",
  scale: "M2 9h5v5H2zM7 9l6-6M9 3h4v4",
  "rotate-to": "M2 14h12M2 14 11 3M8 14a6 6 0 0 0-2-5",
  "scale-to": "M2 9h5v5H2zM9 3h4v4M2 6V2h4M7 9l6-6",
  mirror: "M8 1v14M6 4 2 12h4zM10 4l4 8h-4z",
  "array-rect": "M2 2h4v4H2zM10 2h4v4h-4zM2 10h4v4H2zM10 10h4v4h-4z",
  "array-round":
    "M8 1.500a1.500 1.500 0 1 0 .01 0M2.500 9.500a1.500 1.500 0 1 0 .01 0M13.500 9.500a1.500 1.500 0 1 0 .01 0",
  clip: "M4 3h8v11H4zM6 3V1.500h4V3",
  paste: "M4 3h8v11H4zM8 6v5M6 9l2 2 2-2",
  "paste-absolute": "M5 3h9v11H5zM2 1v14M1 12h14",
  origin: "M3 1v12h12M1 3l2-2 2 2M13 11l2 2-2 2",
  start: "M3 13V3h10M3 3l4 1M3 3l1 4",
  reverse: "M2 6h10l-3-3M14 10H4l3 3",
  directions: "M2 2h12v12H2zM5 5h6v6H5zM8 14l-2-1.500M8 5l2 1",
  pause: "M5 3v10M11 3v10",
  "no-pause": "M5 3v10M11 3v10M2 2l12 12",
  sequence: "M2 4h1v8M7 5c3-3 4 1 0 7h4",
  "sequence-auto": "M2 14 5 9 9 11 14 3M11 3h3v3",
  "sequence-groups": "M2 3h4v4H2zM2 10h4v4H2zM9 5h4M9 12h4M11 3v4",
  "sequence-level": "M2 2h12v12H2zM5 7h2v5H5zM10 7h2v5h-2z",
  "zoom-window": "M7 2a5 5 0 1 0 .01 0M11 11l4 4M5 7h4M7 5v4",
  engrave: "M2 2h12v12H2zM5 5h6v6H5zM8 8h.01",
  pocket: "M2 2h12v12H2zM2 6h12M14 10H2",
  array: "M2 2h5v5H2zM9 2h5v5H9zM2 9h5v5H2zM9 9h5v5H9z",
  set: "M3 4h10M3 8h10M3 12h10M6 2.500v3M11 6.500v3M5 10.500v3",
  justify: "M2 1v13h13M5 4h6v7H5z",
  all: "M3 8h.01M8 8h.01M13 8h.01",
  "sequence-reverse": "M4 2v12M1 11l3 3 3-3M12 14V2M9 5l3-3 3 3",
};

export function ToolIcon({ id }: { id: string }) {
  return (
    <svg viewBox="0 0 16 16" width="16" height="16" aria-hidden="true" className="tool-icon">
      <path d={paths[id] ?? "M8 8h.01"} />
    </svg>
  );
}
