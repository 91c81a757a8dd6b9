#include "model/text/whole_file.h"

#include <fstream>
#include <iterator>

#include "model/text/file_writer.h"

namespace model {

base::Result<std::string> readWholeFile(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file.is_open() || file.bad()) {
        return base::Error{base::ErrorCode::BadInput, path.string() + " cannot be read"};
    }
    return text;
}

base::Status writeWholeFile(const std::filesystem::path& path, const std::string& text) {
    FileWriter writer(path);
    writer.write(text);
    return writer.commit();
}

}  // namespace model
