import { useEffect, useMemo, useRef, useState, useSyncExternalStore } from "react";
import { useScreen, useSnapshot } from "../app/context";
import { useLengthUnit } from "../app/useLengthUnit";
import { DigitizePanel } from "../digitize/DigitizePanel";
import { inUnit, mm } from "../units/quantity";
import { t } from "../words/words";
import { ArrayPanel } from "./ArrayPanel";
import { CommentPanel } from "./CommentPanel";
import { DrawingHead } from "./DrawingHead";
import { DrawingSheet } from "./DrawingSheet";
import { startTool } from "./desk";
import { GroupPanel } from "./GroupPanel";
import { KeyButtons } from "./KeyButtons";
import { Operations } from "./operations/Operations";
import { createOptions, showsMachined } from "./options";
import { SelectionPanel } from "./SelectionPanel";
import { ShapePanel } from "./ShapePanel";
import { sceneOf } from "./scene";
import { SpaceSheet } from "./space/SpaceSheet";
import type { Aspect } from "./space/space";
import { Toolbox } from "./Toolbox";
import { tools } from "./tools/catalog";
import { useDesk } from "./useDesk";
import { useMachined, useShapes } from "./useDrawing";
import { ViewBar } from "./ViewBar";
import { ViewPanel } from "./ViewPanel";
import { expansionFactor, usualExpansion } from "./window";
import "./draw-screen.css";

/** Distance within which a click picks a shape unless a setting says otherwise, pixels. */
const usualRadius = 8;

/** And ends are joined that are so near, mm. */
const usualJoin = mm(0.1);

const nothingPicked: readonly number[] = [];

const round = (value: number): number => Number(value.toFixed(6));

/** The drawing: tools at the left, shapes in the middle, groups at the right. */
export function DrawScreen() {
  const drawing = useSnapshot("drawing");
  const pickRadius = useSnapshot("setup")?.pickRadius || usualRadius;
  const percent = useSnapshot("setup")?.windowExpansion ?? usualExpansion;
  const { loaded, fresh } = useShapes();
  const [optionsStore] = useState(createOptions);
  const options = useSyncExternalStore(optionsStore.watch, optionsStore.get);
  const digitized = useSnapshot("digitized") ?? null;
  const machined = useMachined(showsMachined(options));
  const scene = useMemo(
    () => sceneOf(loaded, drawing, machined, options, digitized),
    [loaded, drawing, machined, options, digitized],
  );
  const lastJoin = round(inUnit(drawing?.join ?? usualJoin, useLengthUnit()));
  const picked = drawing?.picked ?? nothingPicked;
  const ways = { pickRadius, lastJoin, picked, expansion: expansionFactor(percent) };
  const desk = useDesk(scene, ways, fresh);
  const [operation, setOperation] = useState<string | null>(null);
  const [aspect, setAspect] = useState<Aspect>("top");
  const plane = useRef(0);
  const wanted = useScreen("tool");
  // biome-ignore lint/correctness/useExhaustiveDependencies: once for each time it is asked for
  useEffect(() => {
    const tool = tools.find(({ id }) => id === wanted?.id);
    if (tool) desk.act((state, around) => startTool(state, tool, around));
  }, [wanted]);
  // Tools work on the drawing as it is seen from the top.
  const working = desk.state.running !== null;
  useEffect(() => {
    if (working) setAspect("top");
  }, [working]);
  const bar = (
    <ViewBar aspect={aspect} onAspect={setAspect}>
      {aspect === "top" && <KeyButtons desk={desk} menu="window" after={focusSheet} />}
    </ViewBar>
  );
  return (
    <div className="draw">
      <h1 className="hidden-text">{t("Draw")}</h1>
      <DrawingHead desk={desk} />
      <Toolbox desk={desk} onOperation={setOperation} />
      {aspect === "top" ? (
        <DrawingSheet desk={desk} scene={scene} revision={loaded.revision}>
          {bar}
        </DrawingSheet>
      ) : (
        <SpaceSheet scene={scene} aspect={aspect} plane={plane}>
          {bar}
        </SpaceSheet>
      )}
      <div className="draw-right">
        <SelectionPanel desk={desk} scene={scene} notes={machined.notes} />
        <CommentPanel />
        <ArrayPanel onChange={() => setOperation("array")} />
        <GroupPanel desk={desk} scene={scene} />
        <ShapePanel desk={desk} scene={scene} />
        <DigitizePanel />
        <ViewPanel options={options} onChange={(next) => optionsStore.set(next)} />
      </div>
      <Operations open={operation} onOpen={setOperation} />
    </div>
  );
}

/** Keys are heard by the sheet. */
const focusSheet = () => document.querySelector<HTMLElement>(".sheet-box")?.focus();
