import { CommandSheet } from "../command/CommandSheet";
import { ControllerCardSheet } from "../controllerCard/ControllerCardSheet";
import { ControllerLinesSheet } from "../controllerLines/ControllerLinesSheet";
import { ControllerSettingsSheet } from "../controllerSettings/ControllerSettingsSheet";
import { HeightMapSheet } from "../heightmap/HeightMapSheet";
import { KeypadWaits } from "../keypad/KeypadWaits";
import { FilePicker } from "../operator/FilePicker";
import { ProbeSheet } from "../probe/ProbeSheet";
import { KeysSheet } from "../settings/KeysSheet";
import { LoadedFile } from "../settings/LoadSheet";
import { SetupSheet } from "../settings/SetupSheet";
import { SurfacingSheet } from "../surfacing/SurfacingSheet";
import { TimingSheet } from "../timing/TimingSheet";
import { BinSheet } from "../tools/BinSheet";
import { ConfirmSheet } from "../tools/ConfirmSheet";
import { HistorySheet } from "../tools/HistorySheet";
import { InputsSheet } from "../tools/InputsSheet";
import { MacrosSheet } from "../tools/MacrosSheet";
import { MoveToSheet } from "../tools/MoveToSheet";
import { NudgeSheet } from "../tools/NudgeSheet";
import { Palette } from "../tools/Palette";
import { PortsSheet } from "../tools/PortsSheet";
import { RecorderSheet } from "../tools/RecorderSheet";
import { ReplaceSheet } from "../tools/ReplaceSheet";
import { SamplesSheet } from "../tools/SamplesSheet";
import { ScratchSheet } from "../tools/ScratchSheet";
import { ToDoSheet } from "../tools/ToDoSheet";
import { ToolsSheet } from "../tools/ToolsSheet";
import { ValuesSheet } from "../tools/ValuesSheet";
import { VersionsSheet } from "../tools/VersionsSheet";
import { ToolTableSheet } from "../toolTable/ToolTableSheet";
import { TuningSheet } from "../tuning/TuningSheet";
import { WarmUpSheet } from "../warmUp/WarmUpSheet";
import { WiringSheet } from "../wiring/WiringSheet";
import { ZerosSheet } from "../zeros/ZerosSheet";
import { useHands } from "./context";
import type { Sheet } from "./screen";

/** The sheet that is open. */
export function OpenSheet({ sheet }: { sheet: Sheet }) {
  const { screen } = useHands();
  const close = () => screen.open(null);
  switch (sheet.kind) {
    case "files":
      return <FilePicker given={sheet.given} />;
    case "command":
      return <CommandSheet letters={sheet.letters} given={sheet.given} />;
    case "keypad":
      return <KeypadWaits onClose={close} />;
    case "scratch":
      return <ScratchSheet onClose={close} />;
    case "nudge":
      return <NudgeSheet onClose={close} />;
    case "palette":
      return <Palette onClose={close} />;
    case "values":
      return <ValuesSheet key={sheet.which} first={sheet.which} onClose={close} />;
    case "recorder":
      return <RecorderSheet onClose={close} />;
    case "tools":
      return <ToolsSheet onClose={close} />;
    case "inputs":
      return <InputsSheet onClose={close} />;
    case "moveTo":
      return <MoveToSheet onClose={close} />;
    case "probe":
      return <ProbeSheet onClose={close} />;
    case "heightMap":
      return <HeightMapSheet onClose={close} />;
    case "surfacing":
      return <SurfacingSheet onClose={close} />;
    case "tuning":
      return <TuningSheet onClose={close} />;
    case "wiring":
      return <WiringSheet onClose={close} />;
    case "zeros":
      return <ZerosSheet onClose={close} />;
    case "controllerSettings":
      return <ControllerSettingsSheet onClose={close} />;
    case "controllerCard":
      return <ControllerCardSheet onClose={close} />;
    case "controllerLines":
      return <ControllerLinesSheet onClose={close} />;
    case "warmUp":
      return <WarmUpSheet onClose={close} />;
    case "toolTable":
      return <ToolTableSheet onClose={close} />;
    case "ports":
      return <PortsSheet onClose={close} />;
    case "samples":
      return <SamplesSheet onClose={close} />;
    case "history":
      return <HistorySheet onClose={close} />;
    case "todo":
      return <ToDoSheet onClose={close} />;
    case "macros":
      return <MacrosSheet onClose={close} />;
    case "timing":
      return <TimingSheet onClose={close} />;
    case "versions":
      return <VersionsSheet name={sheet.name} onClose={close} />;
    case "loadSettings":
      return <LoadedFile text={sheet.text} onClose={close} />;
    case "setup":
      return <SetupSheet onClose={close} />;
    case "keys":
      return <KeysSheet onClose={close} />;
    case "bin":
      return <BinSheet onClose={close} />;
    case "confirm":
      return <ConfirmSheet action={sheet.action} onClose={close} />;
    case "replace":
      return <ReplaceSheet about={sheet.about} onAnswer={sheet.answer} onClose={close} />;
  }
}
