//! What to do where no window can be opened.

use std::fmt;

/// No window can be opened here, or it was lost. `Display` says what to do instead.
#[derive(Debug)]
pub struct NoWindow {
    pub(super) why: String,
    /// There was one.
    pub(super) lost: bool,
}

impl fmt::Display for NoWindow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.lost {
            return write!(f, "The window was lost: {}.", self.why);
        }
        writeln!(f, "No window can be opened here: {}.", self.why)?;
        writeln!(f, "A picture works without one: add --png picture.png --frame 0 to the command.")?;
        write!(f, "{}", advice())
    }
}

impl std::error::Error for NoWindow {}

fn advice() -> String {
    if !cfg!(all(unix, not(target_os = "macos"))) {
        return "For a window, run this in a session with a desktop, not in a remote shell or a service."
            .into();
    }
    let display = match std::env::var_os("DISPLAY") {
        None => "- DISPLAY is not set. In a desktop's own terminal it is; over ssh, use ssh -X.\n".to_owned(),
        Some(display) => format!("- DISPLAY is {}: is an X server running there?\n", display.display()),
    };
    format!(
        "For a window:\n{display}\
         - In a Wayland session, XWayland must be installed (package xwayland).\n\
         - The libraries libX11 and libXcursor are needed (packages libx11-6 and libxcursor1, or libX11 and libXcursor)."
    )
}
