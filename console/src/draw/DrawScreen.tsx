import { useEffect, useMemo, useState, useSyncExternalStore } from "react";
import { useScreen, useSnapshot } from "../app/context";
import { DrawingHead } from "./DrawingHead";
import { DrawingSheet } from "./DrawingSheet";
import { startTool } from "./desk";
import { GroupPanel } from "./GroupPanel";
import { createOptions } from "./options";
import { SelectionPanel } from "./SelectionPanel";
import { sceneOf } from "./scene";
import { Toolbox } from "./Toolbox";
import { tools } from "./tools/catalog";
import { useDesk } from "./useDesk";
import { useShapes, useToolPaths } from "./useDrawing";
import { ViewPanel } from "./ViewPanel";
import "./draw-screen.css";

/** The drawing: tools at the left, shapes in the middle, groups at the right. */
export function DrawScreen() {
  const drawing = useSnapshot("drawing");
  const loaded = useShapes();
  const [optionsStore] = useState(createOptions);
  const options = useSyncExternalStore(optionsStore.watch, optionsStore.get);
  const paths = useToolPaths(options.toolPaths);
  const scene = useMemo(
    () => sceneOf(loaded, drawing, paths.shapes, options),
    [loaded, drawing, paths, options],
  );
  const desk = useDesk(scene);
  const wanted = useScreen("tool");
  // biome-ignore lint/correctness/useExhaustiveDependencies: once for each time it is asked for
  useEffect(() => {
    const tool = tools.find(({ id }) => id === wanted?.id);
    if (tool) desk.act((state, around) => startTool(state, tool, around));
  }, [wanted]);
  return (
    <div className="draw">
      <h1 className="hidden-text">Draw</h1>
      <DrawingHead desk={desk} />
      <Toolbox desk={desk} />
      <DrawingSheet desk={desk} scene={scene} />
      <div className="draw-right">
        <SelectionPanel desk={desk} scene={scene} notes={paths.notes} />
        <GroupPanel desk={desk} scene={scene} />
        <ViewPanel options={options} onChange={(next) => optionsStore.set(next)} />
      </div>
    </div>
  );
}
