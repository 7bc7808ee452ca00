//! Options of the program beside the machine (Profiler reference, "General Options",
//! "Communication").

/// Serial ports that can be named.
pub const PORTS: usize = 4;

/// Speeds of file sending, baud.
pub const SEND_BAUDS: [u32; 5] = [2400, 4800, 9600, 19_200, 38_400];

/// General options.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Devices of the serial ports 1 … 4.
    pub devices: [String; PORTS],
    /// There is a hand console at its serial port, which is opened.
    pub console: bool,
    /// Serial port of the hand console, 1 … 4.
    pub console_port: u8,
    /// Its speed, baud; always 2400.
    pub console_baud: u32,
    /// Serial port of file sending, 1 … 4.
    pub send_port: u8,
    /// Its speed, baud: one of [`SEND_BAUDS`].
    pub send_baud: u32,
    /// The controller, as `--machine` names it; empty for the simulated machine.
    pub controller: String,
    /// Command that loads firmware into a controller; `{port}` in it is its port. Empty for none.
    pub firmware: String,
    /// Steps in which the spindle warms up, percent of its greatest speed and minutes: `25:2, 50:2`.
    pub warm_up: String,
    /// Salted hash of the password that changing settings needs; none without protection.
    pub password: Option<String>,
    /// Vertices of paths nearer to each other than this are left out, mm; 0 none.
    pub filter_mm: f64,
    /// Joining distance offered, mm.
    pub join_mm: f64,
    /// Radius within which the mouse selects, pixels.
    pub pick_radius_px: f64,
    /// Margin by which the window that shows all is larger than the drawing, percent.
    pub window_expansion_percent: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            devices: std::array::from_fn(|i| format!("/dev/ttyS{i}")),
            console: false,
            console_port: 1,
            console_baud: 2400,
            send_port: 2,
            send_baud: 19_200,
            controller: String::new(),
            firmware: String::new(),
            warm_up: "25:2, 50:2, 75:2, 100:2".into(),
            password: None,
            filter_mm: 0.0,
            join_mm: 0.1,
            pick_radius_px: 8.0,
            window_expansion_percent: 5.0,
        }
    }
}
