#include "model/generate/model_writer.h"

#include <cerrno>
#include <cstring>
#include <fstream>

#include "model/generate/model_text.h"

namespace model::generate {

base::Status writeModel(const Wanted& wanted, const std::filesystem::path& path, base::Progress& progress) {
    const Layout layout(wanted);
    if (!layout.fits()) {
        return base::Error{base::ErrorCode::BadUsage,
                           "a board of so many elements is larger than the ±1.07 m that coordinates may reach"};
    }
    progress.beginPhase("Writing the model");
    errno = 0;
    std::ofstream file(path, std::ios::binary);
    {
        TextSink sink(
            [&](std::string_view text) { file.write(text.data(), static_cast<std::streamsize>(text.size())); });
        if (file) {
            writeModelText(sink, layout, progress);
        }
    }
    file.close();
    if (file && !progress.isCancelled()) {
        return base::Done{};
    }
    const std::string why = errno != 0 ? std::strerror(errno) : "the file cannot be written";
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    return progress.isCancelled() ? base::Error{base::ErrorCode::Cancelled, "cancelled"}
                                  : base::Error{base::ErrorCode::OutputFailed, path.string() + ": " + why};
}

}  // namespace model::generate
