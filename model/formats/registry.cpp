#include "model/formats/registry.h"

#include <fstream>
#include <sstream>

#include "model/formats/odb/odb_reader.h"
#include "model/formats/paper/paper_reader.h"
#include "model/nets/net_inference.h"

namespace model {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSniffBytes = 4096;

std::string readHead(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::string head(kSniffBytes, '\0');
    in.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(in.gcount()));
    return head;
}

base::Result<std::string> readAll(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || !text) {
        return base::Error{base::ErrorCode::BadInput, path.string() + ": cannot be read"};
    }
    return std::move(text).str();
}

using Board = base::Result<std::shared_ptr<const Document>>;

Board readAsItIs(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        return base::Error{base::ErrorCode::BadInput, path.string() + ": there is no such file or folder"};
    }
    if (fs::is_regular_file(status) && paper::looksLikeModel(readHead(path))) {
        base::Result<std::string> text = readAll(path);
        if (!text) {
            return text.error();
        }
        return paper::readModel(*text, path, progress);
    }
    return odb::readJob(path, options, progress);
}

}  // namespace

Board readBoard(const fs::path& path, const ReadOptions& options, base::Progress& progress) {
    Board board = readAsItIs(path, options, progress);
    return board && options.inferNets ? withInferredNets(**board, progress) : board;
}

}  // namespace model
