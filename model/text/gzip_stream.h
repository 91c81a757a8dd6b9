#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace model {

/// Packs bytes as they come into one gzip member (RFC 1952), at a level that costs little more than writing text does.
class GzipStream {
public:
    GzipStream();
    ~GzipStream();
    GzipStream(const GzipStream&) = delete;
    GzipStream& operator=(const GzipStream&) = delete;

    /// Appends to `packed` what of the bytes so far is ready.
    void add(std::string_view bytes, std::string& packed);
    /// The rest. Once, at the end.
    void finish(std::string& packed);

private:
    struct State;
    void run(std::string_view bytes, int flush, std::string& packed);
    std::unique_ptr<State> m_state;
};

}  // namespace model
