import { useState } from "react";
import { Label, Slider, SliderOutput, SliderThumb, SliderTrack } from "react-aria-components";
import { drive } from "../actions/ask";
import { useHands, useSnapshot, worldOf } from "../app/context";
import { Button } from "../ui/Button";
import { t } from "../words/words";
import "./feed-override.css";

const usual = 100;

/** The operator's share of the programmed speed. */
export function FeedOverride() {
  const hands = useHands();
  const told = useSnapshot("overrides")?.feedPercent ?? usual;
  const [held, setHeld] = useState<number | null>(null);
  const ask = (feedPercent: number) => {
    setHeld(null);
    void drive(worldOf(hands), { do: "override", feedPercent });
  };
  return (
    <Slider
      className="feed"
      minValue={10}
      maxValue={200}
      step={5}
      value={held ?? told}
      onChange={setHeld}
      onChangeEnd={ask}
    >
      <Label>{t("Feed")}</Label>
      <SliderOutput className="feed-value">{Math.round(held ?? told)} %</SliderOutput>
      <SliderTrack className="feed-track">
        <SliderThumb className="feed-thumb" />
      </SliderTrack>
      <Button
        size="small"
        refused={told === usual ? t("It is 100 % already.") : undefined}
        onPress={() => ask(usual)}
      >
        100 %
      </Button>
    </Slider>
  );
}
