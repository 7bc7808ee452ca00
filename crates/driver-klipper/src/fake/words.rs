//! The board's dictionary: texts of messages with numbers, packed as boards send it.

use super::Dice;
use std::collections::BTreeMap;

/// Commands that the board knows; the order of fields is its own.
pub const COMMANDS: &[&str] = &[
    "clear_shutdown",
    "emergency_stop",
    "get_uptime",
    "get_clock",
    "finalize_config crc=%u",
    "get_config",
    "allocate_oids count=%c",
    "debug_nop",
    "set_digital_out pin=%u value=%c",
    "update_digital_out oid=%c value=%c",
    "queue_digital_out oid=%c clock=%u on_ticks=%u",
    "set_digital_out_pwm_cycle oid=%c cycle_ticks=%u",
    "config_digital_out oid=%c pin=%u value=%c default_value=%c max_duration=%u",
    "stepper_stop_on_trigger oid=%c trsync_oid=%c",
    "stepper_get_position oid=%c",
    "reset_step_clock oid=%c clock=%u",
    "set_next_step_dir oid=%c dir=%c",
    "queue_step oid=%c interval=%u count=%hu add=%hi",
    "config_stepper oid=%c step_pin=%c dir_pin=%c invert_step=%c step_pulse_ticks=%u",
    "endstop_query_state oid=%c",
    "endstop_home oid=%c clock=%u sample_ticks=%u sample_count=%c \
     rest_ticks=%u pin_value=%c trsync_oid=%c trigger_reason=%c",
    "config_endstop oid=%c pin=%c pull_up=%c",
    "trsync_trigger oid=%c reason=%c",
    "trsync_set_timeout oid=%c clock=%u",
    "trsync_start oid=%c report_clock=%u report_ticks=%u expire_reason=%c",
    "config_trsync oid=%c",
    "config_pwm_out oid=%c pin=%u cycle_ticks=%u value=%hu default_value=%hu max_duration=%u",
    "queue_pwm_out oid=%c clock=%u value=%hu",
    "config_buttons oid=%c button_count=%c",
    "buttons_add oid=%c pos=%c pin=%u pull_up=%c",
    "buttons_query oid=%c clock=%u rest_ticks=%u retransmit_count=%c invert=%c",
    "buttons_ack oid=%c count=%c",
    "config_analog_in oid=%c pin=%u",
    "query_analog_in oid=%c clock=%u sample_ticks=%u sample_count=%c \
     rest_ticks=%u bytes_per_report=%c min_value=%hu max_value=%hu range_check_count=%c",
    "config_tmcuart oid=%c rx_pin=%u pull_up=%c tx_pin=%u bit_time=%u",
    "tmcuart_send oid=%c write=%*s read=%c",
    "config_spi oid=%c pin=%u cs_active_high=%c",
    "spi_set_sw_bus oid=%c miso_pin=%u mosi_pin=%u sclk_pin=%u mode=%u pulse_ticks=%u",
    "spi_transfer oid=%c data=%*s",
    "invented_command oid=%c far=%i",
];

pub const RESPONSES: &[&str] = &[
    "starting",
    "is_shutdown static_string_id=%hu",
    "shutdown clock=%u static_string_id=%hu",
    "stats count=%u sum=%u sumsq=%u",
    "uptime high=%u clock=%u",
    "clock clock=%u",
    "config is_config=%c crc=%u is_shutdown=%c move_count=%hu",
    "stepper_position oid=%c pos=%i",
    "endstop_state oid=%c homing=%c next_clock=%u pin_value=%c",
    "trsync_state oid=%c can_trigger=%c trigger_reason=%c clock=%u",
    "buttons_state oid=%c ack_count=%c state=%*s",
    "analog_in_state oid=%c next_clock=%u values=%*s",
    "tmcuart_response oid=%c read=%*s",
    "spi_transfer_response oid=%c response=%*s",
    "invented_response what=%hi",
];

pub const REASONS: &[&str] = &[
    "Timer too close",
    "Command request",
    "Shutdown cleared when not shutdown",
    "Move queue overflow",
    "Stepper too far in past",
    "Can't reset time when stepper active",
    "Invalid count parameter",
    "Missed scheduling of next digital out event",
    "Missed scheduling of next hard pwm event",
    "Scheduled digital out event will exceed max_duration",
    "update_digital_out not valid with active queue",
    "Scheduled pwm event will exceed max_duration",
    "Invalid oid type",
    "Can't assign oid",
    "oids already allocated",
    "Already finalized",
    "Command parser error",
    "Invalid command",
    "Can't add signal that is already active",
    "ADC out of range",
];

/// A message with its fields: names, codes.
#[derive(Clone, Debug)]
pub struct Form {
    pub number: i64,
    pub text: String,
    pub name: String,
    pub fields: Vec<(String, String)>,
}

#[derive(Clone, Debug, Default)]
pub struct Words {
    pub commands: Vec<Form>,
    pub responses: Vec<Form>,
    pub reasons: Vec<(u32, String)>,
    pub constants: BTreeMap<String, serde_json::Value>,
    pub packed: Vec<u8>,
}

/// A command that came, or a response to be sent.
#[derive(Clone, Debug, Default)]
pub struct Said {
    pub name: String,
    pub numbers: BTreeMap<String, i64>,
    pub bytes: BTreeMap<String, Vec<u8>>,
}

impl Said {
    pub fn n(&self, field: &str) -> i64 {
        *self.numbers.get(field).unwrap_or_else(|| panic!("{} has no {field}", self.name))
    }

    pub fn clock(&self, field: &str) -> u32 {
        self.n(field) as u32
    }
}

fn form(text: &str, number: i64) -> Form {
    let mut words = text.split(' ');
    let name = words.next().unwrap().to_owned();
    let fields = words.map(|word| word.split_once('=').unwrap());
    let fields = fields.map(|(name, code)| (name.to_owned(), code.to_owned())).collect();
    Form { number, text: text.to_owned(), name, fields }
}

impl Words {
    /// Words with numbers without order, negative ones and ones of two bytes among them.
    pub fn shuffled(seed: u64, frequency: f64) -> Self {
        let mut dice = Dice(seed);
        let mut numbers: Vec<i64> = (-32..=140).filter(|n| ![0, 1].contains(n)).collect();
        for at in (1..numbers.len()).rev() {
            numbers.swap(at, dice.below(at as u64 + 1) as usize);
        }
        let mut numbers = numbers.into_iter();
        let mut list = |texts: &[&str]| -> Vec<Form> {
            texts
                .iter()
                .map(|text| form(&turned(text, &mut dice), numbers.next().unwrap()))
                .collect()
        };
        let (mut commands, mut responses) = (list(COMMANDS), list(RESPONSES));
        commands.push(form("identify offset=%u count=%c", 1));
        responses.push(form("identify_response offset=%u data=%.*s", 0));
        let reasons =
            REASONS.iter().enumerate().map(|(n, text)| (2 + n as u32 * 3, (*text).to_owned()));
        let mut words = Self { commands, responses, reasons: reasons.collect(), ..Self::default() };
        words.constants.insert("CLOCK_FREQ".to_owned(), serde_json::json!(frequency));
        words.constants.insert("MCU".to_owned(), serde_json::json!("rp2040"));
        words.constants.insert("STEPPER_STEP_BOTH_EDGE".to_owned(), serde_json::json!(1));
        words.pack();
        words
    }

    /// Words from lists: number and text.
    pub fn listed(
        commands: &[(i64, &str)],
        responses: &[(i64, &str)],
        reasons: &[(u32, &str)],
    ) -> Self {
        let forms = |list: &[(i64, &str)]| list.iter().map(|(n, text)| form(text, *n)).collect();
        let reasons = reasons.iter().map(|(n, text)| (*n, (*text).to_owned())).collect();
        let mut words = Self {
            commands: forms(commands),
            responses: forms(responses),
            reasons,
            ..Self::default()
        };
        words.pack();
        words
    }

    pub fn pack(&mut self) {
        let list = |forms: &[Form]| -> serde_json::Map<String, serde_json::Value> {
            forms.iter().map(|f| (f.text.clone(), f.number.into())).collect()
        };
        let reasons: BTreeMap<&str, u32> =
            self.reasons.iter().map(|(n, t)| (t.as_str(), *n)).collect();
        let all = serde_json::json!({
            "version": "fake-1",
            "commands": list(&self.commands),
            "responses": list(&self.responses),
            "output": {"debug %u of %hi": 141},
            "config": self.constants,
            "enumerations": {
                "pin": {"gpio0": [0, 60], "PA0": [64, 8], "ADC": 100},
                "static_string_id": reasons,
            },
        });
        self.packed = miniz_oxide::deflate::compress_to_vec_zlib(all.to_string().as_bytes(), 6);
    }

    pub fn reason(&self, text: &str) -> i64 {
        let found = self.reasons.iter().find(|(_, t)| t == text);
        i64::from(found.unwrap_or_else(|| panic!("no reason {text}")).0)
    }

    /// Takes a command from the front of a frame's content.
    pub fn command(&self, bytes: &mut &[u8]) -> Result<Said, &'static str> {
        let number = i64::from(number(bytes).ok_or("Command parser error")? as i32);
        let found = self.commands.iter().find(|form| form.number == number);
        let form = found.ok_or("Invalid command")?;
        let mut said = Said { name: form.name.clone(), ..Said::default() };
        for (name, code) in &form.fields {
            let n = number_or(bytes)?;
            if code.ends_with('s') {
                let length = n as usize;
                if bytes.len() < length {
                    return Err("Command parser error");
                }
                said.bytes.insert(name.clone(), bytes[..length].to_vec());
                *bytes = &bytes[length..];
            } else {
                said.numbers.insert(name.clone(), narrow(code, n));
            }
        }
        Ok(said)
    }

    /// Bytes of a response.
    pub fn response(&self, name: &str, numbers: &[(&str, i64)], data: Option<&[u8]>) -> Vec<u8> {
        let form = self.responses.iter().find(|form| form.name == name).unwrap();
        let mut out = Vec::new();
        put(form.number, &mut out);
        for (field, code) in &form.fields {
            if code.ends_with('s') {
                let data = data.unwrap();
                put(data.len() as i64, &mut out);
                out.extend(data);
            } else {
                put(numbers.iter().find(|(name, _)| name == field).unwrap().1, &mut out);
            }
        }
        out
    }
}

/// The fields of some messages in another order.
fn turned(text: &str, dice: &mut Dice) -> String {
    let mut words: Vec<&str> = text.split(' ').collect();
    for at in (2..words.len()).rev() {
        words.swap(at, 1 + dice.below(at as u64) as usize);
    }
    words.join(" ")
}

fn narrow(code: &str, n: u32) -> i64 {
    match code {
        "%c" => i64::from(n as u8),
        "%hu" => i64::from(n as u16),
        "%hi" => i64::from(n as i16),
        "%i" => i64::from(n as i32),
        _ => i64::from(n),
    }
}

fn number_or(bytes: &mut &[u8]) -> Result<u32, &'static str> {
    number(bytes).ok_or("Command parser error")
}

/// Takes a number, arithmetic modulo 2^32.
pub fn number(bytes: &mut &[u8]) -> Option<u32> {
    let first = *bytes.first()?;
    let mut value = i64::from(first & 0x7f);
    if first & 0x60 == 0x60 {
        value -= 128;
    }
    let (mut byte, mut used) = (first, 1);
    while byte & 0x80 != 0 {
        byte = *bytes.get(used)?;
        used += 1;
        value = value * 128 + i64::from(byte & 0x7f);
    }
    *bytes = &bytes[used..];
    Some(value as u32)
}

/// Appends a number, as boards do: above 2^31 without sign.
pub fn put(value: i64, out: &mut Vec<u8>) {
    let value = if value > i64::from(u32::MAX) { value & 0xffff_ffff } else { value };
    let mut groups = vec![(value & 0x7f) as u8];
    let mut rest = value >> 7;
    // One more group as long as the sign would not be read back.
    while !(rest == 0 && groups.last().unwrap() & 0x60 != 0x60
        || rest == -1 && groups.last().unwrap() & 0x60 == 0x60)
    {
        groups.push((rest & 0x7f) as u8);
        rest >>= 7;
    }
    for (n, group) in groups.iter().enumerate().rev() {
        out.push(if n > 0 { group | 0x80 } else { *group });
    }
}
