//! What kernels call beside arithmetic, so that no library of the system is asked: elementary functions are then the same
//! on every machine. Those that are not here (sin, cos, exp, log, sqrt, memset, ...) are in Zig's compiler-rt.

const std = @import("std");

export fn acos(x: f64) callconv(.c) f64 {
    return std.math.acos(x);
}

export fn asin(x: f64) callconv(.c) f64 {
    return std.math.asin(x);
}

export fn atan(x: f64) callconv(.c) f64 {
    return std.math.atan(x);
}

export fn atan2(y: f64, x: f64) callconv(.c) f64 {
    return std.math.atan2(y, x);
}

export fn cosh(x: f64) callconv(.c) f64 {
    return std.math.cosh(x);
}

export fn hypot(x: f64, y: f64) callconv(.c) f64 {
    return std.math.hypot(x, y);
}

export fn pow(x: f64, y: f64) callconv(.c) f64 {
    return std.math.pow(f64, x, y);
}

export fn sinh(x: f64) callconv(.c) f64 {
    return std.math.sinh(x);
}

export fn tanh(x: f64) callconv(.c) f64 {
    return std.math.tanh(x);
}

/// Strides of a contiguous array in another shape. numba calls it by this name; kernels reshape contiguous arrays alone.
export fn numba_attempt_nocopy_reshape(
    _: i64,
    _: [*]const i64,
    _: [*]const i64,
    n: i64,
    sizes: [*]const i64,
    strides: [*]i64,
    size_of_item: i64,
    _: c_int,
) callconv(.c) c_int {
    var step = size_of_item;
    var k: usize = @intCast(n);
    while (k > 0) {
        k -= 1;
        strides[k] = step;
        step *= sizes[k];
    }
    return 1;
}
