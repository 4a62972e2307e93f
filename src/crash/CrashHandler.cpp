#include "crash/CrashHandler.h"

#define UNW_LOCAL_ONLY  // libunwind's way to ask for its small interface
#include <fcntl.h>
#include <libunwind.h>
#include <link.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <utility>

#include "base/CrashNotes.h"
#include "base/UserFolder.h"
#include "crash/BuildId.h"

namespace gt {
namespace {

struct SignalName {
  int number;
  std::string_view name;
};
constexpr std::array deadlySignals{SignalName{SIGSEGV, "SIGSEGV"}, SignalName{SIGBUS, "SIGBUS"},
                                   SignalName{SIGILL, "SIGILL"},   SignalName{SIGFPE, "SIGFPE"},
                                   SignalName{SIGABRT, "SIGABRT"}, SignalName{SIGTRAP, "SIGTRAP"},
                                   SignalName{SIGSYS, "SIGSYS"}};

constexpr std::size_t handlerStackSize = 256 * 1024;
constexpr std::size_t stackBytes = 16 * 1024, stackLine = 32;
constexpr int deepestFrame = 200;

// A signal handler takes no arguments: what it needs has to lie where it finds it.
struct Prepared {
  std::array<char, PATH_MAX> path{};  ///< Of the report, absolute.
  std::array<char, 100> program{};
  std::array<char, 64 * 1024> head{};  ///< The program and its modules, as the report shows them.
  std::size_t headSize = 0;
  std::atomic_flag dying = ATOMIC_FLAG_INIT;
};
Prepared prepared;

/// Writes text and numbers to a file with nothing but write(), which a handler may call.
class Output {
 public:
  explicit Output(int file) : file_{file} {}
  ~Output() { flush(); }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  Output& operator<<(std::string_view text) {
    for (const char c : text) put(c);
    return *this;
  }
  Output& decimal(std::uint64_t number) {
    std::array<char, 20> digits;
    std::size_t n = 0;
    do digits[n++] = static_cast<char>('0' + number % 10);
    while ((number /= 10) > 0);
    while (n > 0) put(digits[--n]);
    return *this;
  }
  Output& hex(std::uint64_t number) {
    *this << "0x";
    for (int shift = 60; shift >= 0; shift -= 4)
      if (number >> shift != 0 || shift == 0) digit(number >> shift & 15);
    return *this;
  }
  Output& byte(unsigned char byte) {
    digit(byte >> 4);
    digit(byte & 15);
    return *this;
  }
  void flush() {
    for (std::size_t at = 0; at < size_;) {
      const ssize_t n = write(file_, buffer_.data() + at, size_ - at);
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) break;
      at += static_cast<std::size_t>(n);
    }
    size_ = 0;
  }

 private:
  void digit(std::uint64_t value) { put("0123456789abcdef"[value]); }
  void put(char c) {
    if (size_ == buffer_.size()) flush();
    buffer_[size_++] = c;
  }

  int file_;
  std::array<char, 4096> buffer_;
  std::size_t size_ = 0;
};

struct Register {
  std::string_view name;
  std::uint64_t value;
};

#if defined(__x86_64__)
auto registersOf(const ucontext_t& context) {
  const auto& r = context.uc_mcontext.gregs;
  const auto value = [&](int i) { return static_cast<std::uint64_t>(r[i]); };
  return std::array{Register{"rip", value(REG_RIP)}, Register{"rsp", value(REG_RSP)},
                    Register{"rbp", value(REG_RBP)}, Register{"rax", value(REG_RAX)},
                    Register{"rbx", value(REG_RBX)}, Register{"rcx", value(REG_RCX)},
                    Register{"rdx", value(REG_RDX)}, Register{"rsi", value(REG_RSI)},
                    Register{"rdi", value(REG_RDI)}, Register{"r8", value(REG_R8)},
                    Register{"r9", value(REG_R9)},   Register{"r10", value(REG_R10)},
                    Register{"r11", value(REG_R11)}, Register{"r12", value(REG_R12)},
                    Register{"r13", value(REG_R13)}, Register{"r14", value(REG_R14)},
                    Register{"r15", value(REG_R15)}, Register{"eflags", value(REG_EFL)}};
}
#elif defined(__aarch64__)
auto registersOf(const ucontext_t& context) {
  constexpr std::string_view names[] = {"x0",  "x1",  "x2",  "x3",  "x4",  "x5",  "x6",  "x7",
                                        "x8",  "x9",  "x10", "x11", "x12", "x13", "x14", "x15",
                                        "x16", "x17", "x18", "x19", "x20", "x21", "x22", "x23",
                                        "x24", "x25", "x26", "x27", "x28", "x29", "x30"};
  std::array<Register, 2 + std::size(names)> all{Register{"pc", context.uc_mcontext.pc},
                                                 Register{"sp", context.uc_mcontext.sp}};
  for (std::size_t i = 0; i < std::size(names); ++i)
    all[i + 2] = {names[i], context.uc_mcontext.regs[i]};
  return all;
}
#else
#error "The crash handler knows the registers of x86-64 and AArch64 only."
#endif

void writeSignal(Output& out, int number, const siginfo_t& info) {
  std::string_view name = "?";
  for (const SignalName& s : deadlySignals)
    if (s.number == number) name = s.name;
  out << "signal ";
  out.decimal(static_cast<std::uint64_t>(number)) << " " << name << "\ncode ";
  if (info.si_code < 0) out << "-";
  out.decimal(static_cast<std::uint64_t>(std::abs(info.si_code))) << "\n";
  if (info.si_code <= 0) {
    out << "sender ";
    out.decimal(static_cast<std::uint64_t>(info.si_pid)) << "\n";
  } else if (number == SIGSEGV || number == SIGBUS || number == SIGILL || number == SIGFPE) {
    out << "address ";
    out.hex(reinterpret_cast<std::uintptr_t>(info.si_addr)) << "\n";
  }
  timespec now{};
  clock_gettime(CLOCK_REALTIME, &now);
  out << "time ";
  out.decimal(static_cast<std::uint64_t>(now.tv_sec)) << "\nprocess ";
  out.decimal(static_cast<std::uint64_t>(getpid())) << "\nthread ";
  out.decimal(static_cast<std::uint64_t>(syscall(SYS_gettid))) << "\n";
}

/// What the thread that died did, and what all have noted.
void writeNotes(Output& out) {
  bool any = false;
  CrashContext::forEachPart([&](std::string_view part) {
    if (!std::exchange(any, true)) out << "running ";
    out << part;
  });
  if (any) out << "\n";
  const CrashNotes& notes = CrashNotes::ofProcess();
  for (std::uint64_t note = notes.begin(); note < notes.end(); ++note) {
    out << "note ";
    notes.forEachLetter(note, [&](char letter) { out << std::string_view{&letter, 1}; });
    out << "\n";
  }
}

/// The memory from the stack pointer on, as far as there is any: read in a way that cannot fault.
void writeStack(Output& out, std::uint64_t pointer) {
  std::array<unsigned char, stackLine> bytes;
  for (std::uint64_t at = pointer; at < pointer + stackBytes; at += stackLine) {
    const iovec to{bytes.data(), bytes.size()};
    const iovec from{reinterpret_cast<void*>(at), bytes.size()};
    if (syscall(SYS_process_vm_readv, getpid(), &to, 1, &from, 1, 0) !=
        static_cast<long>(bytes.size()))
      return;
    out << "stack ";
    out.hex(at) << " ";
    for (const unsigned char byte : bytes) out.byte(byte);
    out << "\n";
  }
}

void writeFrames(Output& out, ucontext_t& context) {
  unw_cursor_t cursor;
  if (unw_init_local2(&cursor, &context, UNW_INIT_SIGNAL_FRAME) != 0) return;
  for (int i = 0; i < deepestFrame; ++i) {
    unw_word_t address = 0;
    if (unw_get_reg(&cursor, UNW_REG_IP, &address) != 0 || address == 0) return;
    out << "frame ";
    out.hex(address) << "\n";
    out.flush();
    if (unw_step(&cursor) <= 0) return;
  }
}

/// Opens the report, for which it makes the folders; negative if that fails.
int openReport() {
  for (char& c : prepared.path) {
    if (c != '/' || &c == prepared.path.data()) continue;
    c = 0;
    mkdir(prepared.path.data(), 0755);
    c = '/';
  }
  return open(prepared.path.data(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
}

void writeReport(int number, const siginfo_t& info, ucontext_t& context) {
  const int file = openReport();
  Output{STDERR_FILENO} << (isatty(STDERR_FILENO) ? "\n" : "")  // behind a progress bar
                        << prepared.program.data() << ": crashed; "
                        << (file < 0 ? "cannot write " : "crashlog reads the report ")
                        << prepared.path.data() << "\n";
  if (file < 0) return;
  {
    Output out{file};
    out << std::string_view{prepared.head.data(), prepared.headSize};
    writeSignal(out, number, info);
    const auto registers = registersOf(context);
    for (const Register& r : registers) {
      out << "register " << r.name << " ";
      out.hex(r.value) << "\n";
    }
    writeNotes(out);
    writeStack(out, registers[1].value);
    out.flush();
    // Last, as it is the only step that could go wrong: it reads the tables of a process that may
    // be in any state.
    writeFrames(out, context);
    out << "end\n";
  }
  close(file);
}

void handle(int number, siginfo_t* info, void* context) {
  if (prepared.dying.test_and_set()) {
    // Another thread is at it, and will end the process; or the handler itself has crashed.
    static_cast<void>(signal(number, SIG_DFL));
    return;
  }
  // Whatever happens, the process does not hang.
  static_cast<void>(signal(SIGALRM, SIG_DFL));
  alarm(10);
  writeReport(number, *info, *static_cast<ucontext_t*>(context));
  alarm(0);
  static_cast<void>(signal(number, SIG_DFL));
  raise(number);
}

/// Fills the report's head, which is written before anything has gone wrong.
class Head {
 public:
  void add(std::string_view text) {
    const std::size_t n = std::min(text.size(), prepared.head.size() - prepared.headSize);
    std::memcpy(prepared.head.data() + prepared.headSize, text.data(), n);
    prepared.headSize += n;
  }
};

std::string moduleBuildId(const dl_phdr_info& module) {
  for (int i = 0; i < module.dlpi_phnum; ++i) {
    const auto& header = module.dlpi_phdr[i];
    if (header.p_type != PT_NOTE) continue;
    const auto* notes = reinterpret_cast<const char*>(module.dlpi_addr + header.p_vaddr);
    if (std::string id = buildIdOf(std::string_view{notes, header.p_memsz}); !id.empty()) return id;
  }
  return "-";
}

/// A line of the report: module BASE BEGIN END BUILDID PATH.
int addModule(dl_phdr_info* module, std::size_t, void* head) {
  std::uint64_t begin = ~std::uint64_t{0}, end = 0;
  for (int i = 0; i < module->dlpi_phnum; ++i) {
    const auto& header = module->dlpi_phdr[i];
    if (header.p_type != PT_LOAD) continue;
    begin = std::min<std::uint64_t>(begin, module->dlpi_addr + header.p_vaddr);
    end = std::max<std::uint64_t>(end, module->dlpi_addr + header.p_vaddr + header.p_memsz);
  }
  std::string path = module->dlpi_name;
  if (path.empty()) {
    std::array<char, PATH_MAX> self{};
    const ssize_t n = readlink("/proc/self/exe", self.data(), self.size());
    path = n > 0 ? std::string(self.data(), static_cast<std::size_t>(n)) : "?";
  }
  static_cast<Head*>(head)->add("module " + hexText(module->dlpi_addr) + " " + hexText(begin) +
                                " " + hexText(end) + " " + moduleBuildId(*module) + " " + path +
                                "\n");
  return 0;
}

}  // namespace

CrashStack::CrashStack()
    : memory_{mmap(nullptr, handlerStackSize, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS,
                   -1, 0)} {
  if (memory_ == MAP_FAILED) return;
  stack_t stack{};
  stack.ss_sp = memory_;
  stack.ss_size = handlerStackSize;
  sigaltstack(&stack, nullptr);
}

CrashStack::~CrashStack() {
  if (memory_ == MAP_FAILED) return;
  stack_t none{};
  none.ss_flags = SS_DISABLE;
  sigaltstack(&none, nullptr);
  munmap(memory_, handlerStackSize);
}

std::string crashFolder() {
  const std::string folder = userFolder(UserFolder::state);
  return (folder.empty() ? "/tmp/gt2003-" + std::to_string(getuid()) : folder) + "/crashes";
}

void installCrashHandler(const CrashSettings& settings) {
  const std::string name = "crash-" + settings.program + "-" + std::to_string(getpid()) + ".txt";
  std::error_code failed;
  const auto path = std::filesystem::absolute(settings.folder, failed) / name;
  std::strncpy(prepared.path.data(), path.c_str(), prepared.path.size() - 1);
  std::strncpy(prepared.program.data(), settings.program.c_str(), prepared.program.size() - 1);
  prepared.headSize = 0;
  Head head;
  head.add("gt2003 crash report 1\nprogram " + settings.program + "\n");
  dl_iterate_phdr(&addModule, &head);
  static CrashStack stack;
  // Has libunwind load what it needs while that is still allowed.
  unw_context_t context;
  unw_cursor_t cursor;
  if (unw_getcontext(&context) == 0 && unw_init_local(&cursor, &context) == 0) unw_step(&cursor);
  struct sigaction action {};
  action.sa_sigaction = &handle;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigfillset(&action.sa_mask);
  sigdelset(&action.sa_mask, SIGALRM);
  for (const SignalName& s : deadlySignals) sigaction(s.number, &action, nullptr);
}

}  // namespace gt
