//! An error of its own that holds HTML and a script.
//!
//! expect: does-not-compile "<script>"

compile_error!("</pre><script>document.title = 'taken over'</script><img src=x onerror=alert(1)>");
