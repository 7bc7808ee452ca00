import type { Kind } from "./kinds";

/** The picture of a kind: what is touched, the tool where it begins, its touches as numbered arrows. */
export function Picture({ scene: { solid, tool, touches } }: Pick<Kind, "scene">) {
  return (
    <svg className="probe-picture" viewBox="0 0 120 80" aria-hidden="true">
      <defs>
        <marker
          id="probe-tip"
          viewBox="0 0 6 6"
          refX="5"
          refY="3"
          markerWidth="6"
          markerHeight="6"
          orient="auto"
        >
          <path d="M0 0L6 3L0 6Z" />
        </marker>
      </defs>
      <path className="probe-solid" fillRule="evenodd" d={solid} />
      {touches.map(([x1, y1, x2, y2]) => (
        <line key={`${x1} ${y1}`} {...{ x1, y1, x2, y2 }} markerEnd="url(#probe-tip)" />
      ))}
      <circle className="probe-tool" cx={tool[0]} cy={tool[1]} r="5" />
    </svg>
  );
}
