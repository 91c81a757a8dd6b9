#include "app/common/exit_code.h"

#include <cstdio>

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

}  // namespace app
