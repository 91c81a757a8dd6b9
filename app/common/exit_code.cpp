#include "app/common/exit_code.h"

#include <cstdio>
#include <iostream>

namespace app {

int fail(const base::Error& error) {
    std::fprintf(stderr, "copperscope: %s\n", error.text.c_str());
    switch (error.code) {
        case base::ErrorCode::BadUsage: return kWrongUsage;
        case base::ErrorCode::BadInput: return kBadInput;
        case base::ErrorCode::Cancelled:
        case base::ErrorCode::DeviceFailed:
        case base::ErrorCode::OutputFailed: return kFailed;
    }
    return kFailed;
}

int endOutput(int code) {
    std::cout.flush();
    const bool isWritten = std::fflush(stdout) == 0 && std::cout && std::ferror(stdout) == 0;
    if (isWritten || (code != kDone && code != kTooClose)) {
        return code;
    }
    return fail({base::ErrorCode::OutputFailed, "what was to be said cannot be written to stdout"});
}

}  // namespace app
