#include "model/generate/model_writer.h"

#include "model/generate/model_text.h"
#include "model/text/file_writer.h"

namespace model::generate {

base::Status writeModel(const Wanted& wanted, const std::filesystem::path& path, base::Progress& progress) {
    const Layout layout(wanted);
    if (!layout.fits()) {
        return base::Error{base::ErrorCode::BadUsage,
                           "a board of so many elements is larger than the ±1.07 m that coordinates may reach"};
    }
    progress.beginPhase("Writing the model");
    FileWriter file(path);
    RETURN_IF_ERROR(file.status());
    {
        TextSink sink([&](std::string_view text) { file.write(text); });
        writeModelText(sink, layout, progress);
    }
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    return file.commit();
}

}  // namespace model::generate
