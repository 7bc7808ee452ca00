//! The commands that Kerf sends, each with the fields that it means, and the way to write them for one board.

use crate::dictionary::{Dictionary, DictionaryError, EncodeError, Encoder, Value, Wanted};

/// The reason for which something cannot be told to a board.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum OrderError {
    /// The board does not know it.
    #[error(transparent)]
    Unknown(#[from] DictionaryError),
    /// A value does not fit.
    #[error(transparent)]
    Value(#[from] EncodeError),
}

macro_rules! orders {
    ($($order:ident $name:literal [$($field:literal)*] $doc:literal;)*) => {
        /// A command that Kerf sends.
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum Order {
            $(#[doc = $doc] $order,)*
        }

        /// Names and fields, in the order of [`Order`].
        const TABLE: &[Wanted] = &[$(Wanted { name: $name, fields: &[$($field),*] },)*];
    };
}

orders! {
    Uptime "get_uptime" [] "The clock since power-up.";
    Clock "get_clock" [] "The clock.";
    Config "get_config" [] "The state of the configuration.";
    Allocate "allocate_oids" ["count"] "Number of objects.";
    Finalize "finalize_config" ["crc"] "The configuration is whole.";
    EmergencyStop "emergency_stop" [] "Everything stops at once.";
    ClearShutdown "clear_shutdown" [] "The shutdown is over.";
    Reset "reset" [] "The chip begins anew.";
    ConfigReset "config_reset" [] "The program begins anew.";
    ConfigStepper "config_stepper" ["oid" "step_pin" "dir_pin" "invert_step" "step_pulse_ticks"] "A motor.";
    ConfigEndstop "config_endstop" ["oid" "pin" "pull_up"] "A switch.";
    ConfigTrsync "config_trsync" ["oid"] "A latch that stops motors.";
    ConfigDigital "config_digital_out" ["oid" "pin" "value" "default_value" "max_duration"] "An output.";
    ConfigPwm "config_pwm_out" ["oid" "pin" "cycle_ticks" "value" "default_value" "max_duration"] "A PWM output.";
    ConfigAnalog "config_analog_in" ["oid" "pin"] "A voltage.";
    ConfigButtons "config_buttons" ["oid" "button_count"] "A row of inputs.";
    AddButton "buttons_add" ["oid" "pos" "pin" "pull_up"] "An input of a row.";
    ConfigDriverUart "config_tmcuart" ["oid" "rx_pin" "pull_up" "tx_pin" "bit_time"] "A wire to motor drivers.";
    QueueStep "queue_step" ["oid" "interval" "count" "add"] "Steps.";
    NextDir "set_next_step_dir" ["oid" "dir"] "Direction of the steps that follow.";
    ResetStepClock "reset_step_clock" ["oid" "clock"] "Clock from which the steps that follow count.";
    Position "stepper_get_position" ["oid"] "Steps made.";
    StopOnTrigger "stepper_stop_on_trigger" ["oid" "trsync_oid"] "A latch stops a motor.";
    TrsyncStart "trsync_start" ["oid" "report_clock" "report_ticks" "expire_reason"] "A latch is armed.";
    TrsyncTimeout "trsync_set_timeout" ["oid" "clock"] "A latch triggers by itself then.";
    TrsyncTrigger "trsync_trigger" ["oid" "reason"] "A latch triggers now.";
    EndstopHome "endstop_home" ["oid" "clock" "sample_ticks" "sample_count" "rest_ticks" "pin_value" "trsync_oid"
        "trigger_reason"] "A switch is watched.";
    EndstopState "endstop_query_state" ["oid"] "Level of a switch, and its last look.";
    QueueDigital "queue_digital_out" ["oid" "clock" "on_ticks"] "An output changes then.";
    UpdateDigital "update_digital_out" ["oid" "value"] "An output changes now.";
    QueuePwm "queue_pwm_out" ["oid" "clock" "value"] "A PWM output changes then.";
    QueryAnalog "query_analog_in" ["oid" "clock" "sample_ticks" "sample_count" "rest_ticks" "bytes_per_report"
        "min_value" "max_value" "range_check_count"] "A voltage is measured from then on.";
    QueryButtons "buttons_query" ["oid" "clock" "rest_ticks" "retransmit_count" "invert"] "Inputs are looked at.";
    AckButtons "buttons_ack" ["oid" "count"] "Changes of inputs have come.";
    DriverUart "tmcuart_send" ["oid" "write" "read"] "Bits for a motor driver.";
    ConfigSpi "config_spi" ["oid" "pin" "cs_active_high"] "A chip select.";
    SpiBus "spi_set_sw_bus" ["oid" "miso_pin" "mosi_pin" "sclk_pin" "mode" "pulse_ticks"] "Pins of a bus of SPI.";
    Transfer "spi_transfer" ["oid" "data"] "Bytes for a chip, and from it.";
}

/// The commands of one board.
#[derive(Clone, Debug)]
pub struct Orders(Vec<Result<Encoder, DictionaryError>>);

impl Orders {
    /// Looks all of them up. One that is missing is told when it is needed.
    pub fn new(dictionary: &Dictionary) -> Self {
        Self(TABLE.iter().map(|wanted| dictionary.command(wanted)).collect())
    }

    /// The board has a command.
    pub fn has(&self, order: Order) -> bool {
        self.0.get(order as usize).is_some_and(Result::is_ok)
    }

    /// Makes sure that the board has a command.
    ///
    /// # Errors
    ///
    /// It lacks it, or has other fields.
    pub fn require(&self, order: Order) -> Result<(), OrderError> {
        Ok(self.encoder(order).map(drop)?)
    }

    /// Writes a command with numbers, in the order of its fields here.
    ///
    /// # Errors
    ///
    /// The board lacks it, or a number does not fit.
    pub fn write<const N: usize>(
        &self,
        order: Order,
        numbers: [u32; N],
    ) -> Result<Vec<u8>, OrderError> {
        Ok(self.encoder(order)?.numbers(numbers)?)
    }

    /// Writes a command with any values.
    ///
    /// # Errors
    ///
    /// The board lacks it, or a value does not fit.
    pub fn write_values(&self, order: Order, values: &[Value]) -> Result<Vec<u8>, OrderError> {
        Ok(self.encoder(order)?.values(values)?)
    }

    fn encoder(&self, order: Order) -> Result<&Encoder, DictionaryError> {
        let missing = || DictionaryError::Content(format!("{order:?}"));
        self.0.get(order as usize).ok_or_else(missing)?.as_ref().map_err(Clone::clone)
    }
}
