#include "workbench_server.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <httplib.h>
#include <iterator>
#include <sys/socket.h>
#include <thread>
#include <utility>

namespace linkwright::cli {
namespace {

using namespace std::chrono_literals;

constexpr const char* this_machine = "127.0.0.1";
// A connection occupies a thread until its request has come, and browsers open some ahead of need.
constexpr std::size_t threads = 64;
constexpr std::chrono::seconds longest_idle{1}, longest_read{2}, longest_write{10};
constexpr std::chrono::milliseconds longest_end{300};

const httplib::Headers& strict_headers() {
  static const httplib::Headers headers{
      {"Content-Security-Policy",
       "default-src 'self'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self' 'unsafe-inline'; "
       "img-src 'self' data: blob:; worker-src 'self' blob:; connect-src 'self'; object-src 'none'; "
       "base-uri 'none'; frame-ancestors 'none'; form-action 'none'"},
      {"Cross-Origin-Embedder-Policy", "require-corp"},
      {"Cross-Origin-Opener-Policy", "same-origin"},
      {"Cross-Origin-Resource-Policy", "same-origin"},
      {"Referrer-Policy", "no-referrer"},
      {"X-Content-Type-Options", "nosniff"},
  };
  return headers;
}

bool is_digits(std::string_view text) {
  return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// "127.0.0.1:4180", "localhost": any port, since it may be forwarded.
bool names_this_machine(std::string_view host) {
  const auto colon = host.find(':');
  if (colon != std::string_view::npos && !is_digits(host.substr(colon + 1))) return false;
  std::string name(host.substr(0, colon));
  for (char& c : name) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c + ('a' - 'A') : c);
  return name == this_machine || name == "localhost";
}

std::optional<std::string> content_of(const WebFile& file) {
  std::ifstream stream(file.path, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string content{std::istreambuf_iterator<char>(stream), {}};
  return stream.bad() ? std::nullopt : std::optional(std::move(content));
}

/// By a provider of known length: other contents the library would compress, which takes it seconds for a megabyte.
void send(httplib::Response& response, std::string content, std::string_view media_type, const char* caching) {
  response.set_header("Cache-Control", caching);
  const std::string type(media_type);
  if (content.empty()) return response.set_content("", type);  // a provider without a length would be asked for ever
  const auto shared = std::make_shared<const std::string>(std::move(content));
  response.set_content_provider(shared->size(), type,
                                [shared](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
                                  return sink.write(shared->data() + offset, length);
                                });
}

/// Parts of a file are not served: the library (0.11) does not check them against the file's length, and would send
/// what lies behind it in memory. The request is its own, not constant there.
void ignore_ranges(const httplib::Request& request) { const_cast<httplib::Request&>(request).ranges.clear(); }

void refuse(httplib::Response& response, int status, std::string_view sentence) {
  response.status = status;
  send(response, fmt::format("{}: {}\n", status, sentence), "text/plain; charset=utf-8", "no-store");
}

void answer(const WebFolder& folder, const httplib::Request& request, httplib::Response& response) {
  if (request.get_header_value_count("Host") != 1) return refuse(response, 400, "one Host header is needed");
  if (!names_this_machine(request.get_header_value("Host"))) {
    return refuse(response, 421, "the workbench is served to http://127.0.0.1 and http://localhost only");
  }
  if (request.method != "GET" && request.method != "HEAD") {
    response.set_header("Allow", "GET, HEAD");
    return refuse(response, 405, "only GET and HEAD are answered");
  }
  const auto file = folder.find(request.path);
  auto content = file ? content_of(*file) : std::nullopt;
  if (!content) return refuse(response, 404, "there is no such page; the workbench is at /");
  send(response, std::move(*content), file->media_type,
       file->never_changes ? "public, max-age=31536000, immutable" : "no-cache");
}

/// Without SO_REUSEPORT, which the library sets by itself: with it two programs would share the port.
void only_owner_of_its_port(int socket) {
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

sigset_t stopping_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

namespace fs = std::filesystem;

constexpr std::array<std::pair<std::string_view, std::string_view>, 12> media_types{{
    {".css", "text/css; charset=utf-8"},
    {".html", "text/html; charset=utf-8"},
    {".ico", "image/x-icon"},
    {".js", "text/javascript; charset=utf-8"},
    {".json", "application/json"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".png", "image/png"},
    {".svg", "image/svg+xml"},
    {".txt", "text/plain; charset=utf-8"},
    {".wasm", "application/wasm"},
    {".webmanifest", "application/manifest+json"},
    {".woff2", "font/woff2"},
}};

std::string_view media_type_of(const fs::path& path) {
  const std::string extension = path.extension().string();
  const auto* const known =
      std::find_if(media_types.begin(), media_types.end(), [&](const auto& type) { return type.first == extension; });
  return known == media_types.end() ? "application/octet-stream" : known->second;
}

bool lies_within(const fs::path& folder, const fs::path& path) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// What a name inside of a folder may not be, by itself or as a part of a path.
bool is_plain(std::string_view url_path) {
  if (url_path.find('\0') != std::string_view::npos) return false;
  const fs::path path(url_path);
  return std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".." || part == "."; });
}

}  // namespace

struct WorkbenchServer::Http {
  httplib::Server server;
  std::atomic<bool> ended{false};

  /// In a thread of its own: stops the server at the first signal, or ends with it. The library waits for connections
  /// that browsers keep open ahead of need; nothing is lost with them.
  void stop_at_signal() {
    const sigset_t signals = stopping_signals();
    const timespec while_running{0, 100'000'000};
    while (!ended && sigtimedwait(&signals, nullptr, &while_running) < 0) continue;
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
    while (!ended && !server.is_running()) std::this_thread::sleep_for(1ms);
    server.stop();
    for (auto waited = 0ms; waited < longest_end && !ended; waited += 1ms) std::this_thread::sleep_for(1ms);
    if (!ended) std::_Exit(0);
  }
};

WorkbenchServer::WorkbenchServer(WebFolder folder) : http_(std::make_unique<Http>()) {
  const sigset_t signals = stopping_signals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // all threads inherit this
  httplib::Server& server = http_->server;
  server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
  server.set_socket_options(only_owner_of_its_port);
  server.set_tcp_nodelay(true);
  server.set_keep_alive_max_count(1);  // a request's body is never read, so nothing may follow it
  server.set_keep_alive_timeout(longest_idle.count());
  server.set_read_timeout(longest_read);
  server.set_write_timeout(longest_write);
  server.set_default_headers(strict_headers());
  server.set_pre_routing_handler(
      [folder = std::move(folder)](const httplib::Request& request, httplib::Response& response) {
        ignore_ranges(request);
        answer(folder, request, response);
        return httplib::Server::HandlerResponse::Handled;
      });
}

WorkbenchServer::~WorkbenchServer() = default;

std::optional<int> WorkbenchServer::bind(int port) {
  errno = 0;
  httplib::Server& server = http_->server;
  if (port == 0)
    port = server.bind_to_any_port(this_machine);
  else if (!server.bind_to_port(this_machine, port))
    port = -1;
  return port > 0 ? std::optional(port) : std::nullopt;
}

bool WorkbenchServer::serve() {
  std::thread stopper([this] { http_->stop_at_signal(); });
  const bool served = http_->server.listen_after_bind();
  http_->ended = true;
  stopper.join();
  return served;
}

std::optional<WebFolder> WebFolder::open(const fs::path& folder) {
  std::error_code error;
  const fs::path whole = fs::canonical(folder, error);
  if (error || !fs::is_regular_file(whole / "index.html", error)) return std::nullopt;
  return WebFolder(whole);
}

std::optional<WebFile> WebFolder::find(std::string_view url_path) const {
  if (url_path.empty() || url_path.front() != '/' || !is_plain(url_path)) return std::nullopt;
  const fs::path name = url_path == "/" ? fs::path("index.html") : fs::path(url_path).relative_path();
  std::error_code error;
  const fs::path path = fs::canonical(folder_ / name, error);
  if (error || !lies_within(folder_, path) || !fs::is_regular_file(path, error)) return std::nullopt;
  return WebFile{path, media_type_of(path), *name.begin() == "assets"};
}

std::vector<fs::path> places_of_the_workbench() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const fs::path bin = program.parent_path();
  std::vector<fs::path> places{(bin / LINKWRIGHT_WEB_FROM_BIN).lexically_normal()};
  const bool in_a_build_tree = fs::exists(bin.parent_path() / "CMakeCache.txt", error);
  if (in_a_build_tree) places.push_back((bin / "../../web").lexically_normal());
  return places;
}

}  // namespace linkwright::cli
