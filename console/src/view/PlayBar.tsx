import { Slider, SliderThumb, SliderTrack } from "react-aria-components";
import { durationText } from "../app/units";
import { Button } from "../ui/Button";
import { type Seconds, seconds } from "../units/quantity";
import { t } from "../words/words";
import { live, type Playback, speeds, toggled, wound } from "./playback";
import "./play-bar.css";

interface PlayBarProps {
  playback: Playback;
  planned: Seconds;
  onChange: (playback: Playback) => void;
}

/** Plays, holds and winds the simulation. */
export function PlayBar({ playback, planned, onChange }: PlayBarProps) {
  const at = playback.at ?? 0;
  const place = speeds.findIndex((speed) => speed >= playback.speed);
  const faster = speeds[(place + 1) % speeds.length];
  return (
    <div className="play" role="toolbar" aria-label={t("Simulation")}>
      <Button
        size="small"
        aria-label={playback.playing ? t("Hold the simulation") : t("Play the simulation")}
        onPress={() => onChange(toggled(playback, planned))}
      >
        {playback.playing ? "❚❚" : "▶"}
      </Button>
      <Slider
        aria-label={t("Planned time")}
        className="play-slider"
        minValue={0}
        maxValue={planned}
        step={planned / 1000}
        value={at}
        onChange={(to) => onChange(wound(playback, to))}
      >
        <SliderTrack className="play-track">
          <SliderThumb className="play-thumb" />
        </SliderTrack>
      </Slider>
      <span className="play-time">
        {durationText(seconds(at))} / {durationText(planned)}
      </span>
      <Button
        size="small"
        aria-label={t("Speed {0} times", playback.speed)}
        onPress={() => onChange({ ...playback, speed: faster ?? 1 })}
      >
        ×{playback.speed}
      </Button>
      <Button
        size="small"
        refused={playback.at === null ? t("The machine as it is now is shown already.") : undefined}
        onPress={() => onChange(live)}
      >
        Live
      </Button>
    </div>
  );
}
