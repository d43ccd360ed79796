//! The process in which the viewer runs your functions. This file is fixed: yours is `keyframes.rs`.

fn main() {
    // The viewer asks about whole motions: this process poses their frames, and your functions choose among them.
    exam::worker::serve(keyframes::FUNCTIONS.with_clips(inbetween::clip))
}
