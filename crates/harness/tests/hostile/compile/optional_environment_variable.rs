//! Asks for the same variable in a way that does not fail where there is none.
//!
//! expect: graded 15

const STOLEN: Option<&str> = option_env!("FK_LAB_PLANTED");
const _: () = if let Some(stolen) = STOLEN {
    panic!("{}", stolen);
};
