#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <linux/filter.h>
#include <linux/seccomp.h>
#include <linux/sockios.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include "judge/sandbox/system_calls.hpp"

namespace tumble::judge {

namespace {

/// A page at an address that no worker can have: its heap, which starts near 0, ends at its memory
/// limit long before, and the filter refuses mappings at addresses of its own choice. (Below 2 GB,
/// where a judge with AddressSanitizer has room too.)
constexpr std::uintptr_t path_address = 0x7ffe0000;
constexpr std::size_t path_capacity = 4096;

char* path_page() {
  static char* const page = [] {
    // An address that the filter can name beforehand.
    void* const wanted =
        reinterpret_cast<void*>(path_address);  // NOLINT(performance-no-int-to-ptr)
    void* const got = mmap(wanted, path_capacity, PROT_READ | PROT_WRITE,
                           MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED_NOREPLACE, -1, 0);
    if (got != wanted) throw std::runtime_error("no page at the address for paths");
    return static_cast<char*>(got);
  }();
  return page;
}

struct Release {
  void operator()(scmp_filter_ctx context) const { seccomp_release(context); }
};
using Context = std::unique_ptr<void, Release>;

void check(int status, const char* what) {
  if (status < 0)
    throw std::runtime_error(std::string("seccomp: ") + what + ": " + std::strerror(-status));
}

scmp_arg_cmp equals(unsigned argument, std::uint64_t value) {
  return {argument, SCMP_CMP_EQ, value, 0};
}

/// None of these bits is set.
scmp_arg_cmp lacks(unsigned argument, std::uint64_t bits) {
  return {argument, SCMP_CMP_MASKED_EQ, bits, 0};
}

/// All of these bits are set.
scmp_arg_cmp has(unsigned argument, std::uint64_t bits) {
  return {argument, SCMP_CMP_MASKED_EQ, bits, bits};
}

using Conditions = std::vector<scmp_arg_cmp>;

void add_rule(const Context& context, std::uint32_t action, int call,
              const Conditions& conditions = {}) {
  check(seccomp_rule_add_array(context.get(), action, call,
                               static_cast<unsigned>(conditions.size()), conditions.data()),
        "add a rule");
}

void allow(const Context& context, std::initializer_list<int> calls) {
  for (const int call : calls) add_rule(context, SCMP_ACT_ALLOW, call);
}

/// The call fails, and the program goes on.
void deny(const Context& context, const std::vector<int>& calls, int error) {
  for (const int call : calls)
    add_rule(context, SCMP_ACT_ERRNO(static_cast<std::uint32_t>(error)), call);
}

CallFilter exported(const Context& context) {
  static_assert(sizeof(sock_filter) == sizeof(CallFilter::value_type));
  const int file = memfd_create("filter", MFD_CLOEXEC);
  if (file < 0) throw std::runtime_error("seccomp: no memory file for the filter");
  const int status = seccomp_export_bpf(context.get(), file);
  CallFilter filter(static_cast<std::size_t>(lseek(file, 0, SEEK_END)) / sizeof(sock_filter));
  const auto bytes = static_cast<ssize_t>(filter.size() * sizeof(sock_filter));
  const bool complete = pread(file, filter.data(), filter.size() * sizeof(sock_filter), 0) == bytes;
  close(file);
  check(status, "export");
  if (!complete) throw std::runtime_error("seccomp: the filter could not be read back");
  return filter;
}

Context new_context(std::uint32_t otherwise) {
  Context context(seccomp_init(otherwise));
  if (!context) throw std::runtime_error("seccomp: no filter");
  return context;
}

CallFilter build_worker_filter() {
  const Context context = new_context(SCMP_ACT_TRAP);
  // Computing, printing, ending.
  allow(context, {SCMP_SYS(read),         SCMP_SYS(write),        SCMP_SYS(writev),
                  SCMP_SYS(brk),          SCMP_SYS(munmap),       SCMP_SYS(madvise),
                  SCMP_SYS(exit),         SCMP_SYS(exit_group),   SCMP_SYS(clock_gettime),
                  SCMP_SYS(gettimeofday), SCMP_SYS(time),         SCMP_SYS(getrandom),
                  SCMP_SYS(futex),        SCMP_SYS(fstat),        SCMP_SYS(getpid),
                  SCMP_SYS(gettid),       SCMP_SYS(rt_sigaction), SCMP_SYS(rt_sigprocmask),
                  SCMP_SYS(rt_sigreturn), SCMP_SYS(sched_yield)});
  // What a static program does before main.
  allow(context, {SCMP_SYS(set_tid_address), SCMP_SYS(set_robust_list), SCMP_SYS(rseq)});
#ifdef __x86_64__
  allow(context, {SCMP_SYS(arch_prctl)});
#endif
  add_rule(context, SCMP_ACT_ALLOW, SCMP_SYS(prlimit64), {equals(2, 0)});  // ask for limits only
  // What the C library asks and can do without: as on a system that does not have it.
  deny(context, {SCMP_SYS(readlink), SCMP_SYS(readlinkat), SCMP_SYS(uname)}, ENOSYS);
  deny(context, {SCMP_SYS(ioctl)}, ENOTTY);
  // fstat, as newer libraries ask for it. Allowed, it would tell about any path: a filter cannot
  // see whether the path is the empty one.
  add_rule(context, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(newfstatat), {equals(3, AT_EMPTY_PATH)});
  deny(context, {SCMP_SYS(lseek)}, ESPIPE);
  // Memory: never executable, never at an address of the program's choice.
  add_rule(context, SCMP_ACT_ALLOW, SCMP_SYS(mmap), {equals(0, 0), lacks(2, PROT_EXEC)});
  add_rule(context, SCMP_ACT_ALLOW, SCMP_SYS(mprotect), {lacks(2, PROT_EXEC)});
  add_rule(context, SCMP_ACT_ALLOW, SCMP_SYS(mremap), {lacks(3, MREMAP_FIXED)});
  // Being started: see execute_behind_filter.
  add_rule(context, SCMP_ACT_ALLOW, SCMP_SYS(execve), {equals(0, path_address)});
  return exported(context);
}

// What a run with sanitizers may not ask for. Its runtime needs too much for an allow-list.

/// Other processes, and what is of theirs.
const std::vector<int> others_processes = {SCMP_SYS(kill),
                                           SCMP_SYS(tkill),
                                           SCMP_SYS(tgkill),
                                           SCMP_SYS(rt_sigqueueinfo),
                                           SCMP_SYS(rt_tgsigqueueinfo),
                                           SCMP_SYS(pidfd_open),
                                           SCMP_SYS(pidfd_send_signal),
                                           SCMP_SYS(setsid),
                                           SCMP_SYS(setpgid),
                                           SCMP_SYS(fork),
                                           SCMP_SYS(vfork),
                                           SCMP_SYS(ptrace),
                                           SCMP_SYS(process_vm_readv),
                                           SCMP_SYS(process_vm_writev),
                                           SCMP_SYS(process_madvise),
                                           SCMP_SYS(kcmp),
                                           SCMP_SYS(migrate_pages),
                                           SCMP_SYS(move_pages),
                                           SCMP_SYS(setpriority),
                                           SCMP_SYS(sched_setscheduler),
                                           SCMP_SYS(sched_setattr),
                                           SCMP_SYS(sched_setparam),
                                           SCMP_SYS(ioprio_set)};
/// What outlives a process, or belongs to several: to make it, and to use what is there.
const std::vector<int> shared_objects = {
    SCMP_SYS(shmget),          SCMP_SYS(shmat),         SCMP_SYS(shmctl),
    SCMP_SYS(msgget),          SCMP_SYS(msgsnd),        SCMP_SYS(msgrcv),
    SCMP_SYS(msgctl),          SCMP_SYS(semget),        SCMP_SYS(semop),
    SCMP_SYS(semtimedop),      SCMP_SYS(semctl),        SCMP_SYS(mq_open),
    SCMP_SYS(mq_unlink),       SCMP_SYS(mq_notify),     SCMP_SYS(mq_timedsend),
    SCMP_SYS(mq_timedreceive), SCMP_SYS(mq_getsetattr), SCMP_SYS(keyctl),
    SCMP_SYS(add_key),         SCMP_SYS(request_key),   SCMP_SYS(memfd_create)};
/// The network, and messages of the kernel.
const std::vector<int> network = {
    SCMP_SYS(socket),          SCMP_SYS(socketpair),     SCMP_SYS(bind),
    SCMP_SYS(connect),         SCMP_SYS(io_uring_setup), SCMP_SYS(io_setup),
    SCMP_SYS(inotify_init),    SCMP_SYS(inotify_init1),  SCMP_SYS(fanotify_init),
    SCMP_SYS(perf_event_open), SCMP_SYS(userfaultfd)};
/// More rights, and other views of the system.
const std::vector<int> rights = {
    SCMP_SYS(mount),       SCMP_SYS(umount2),          SCMP_SYS(pivot_root),
    SCMP_SYS(chroot),      SCMP_SYS(unshare),          SCMP_SYS(setns),
    SCMP_SYS(bpf),         SCMP_SYS(execveat),         SCMP_SYS(quotactl),
    SCMP_SYS(personality), SCMP_SYS(open_by_handle_at)};
/// Files are read only, also where there is no Landlock.
const std::vector<int> changes_of_files = {
    SCMP_SYS(creat),     SCMP_SYS(openat2),  SCMP_SYS(unlink),    SCMP_SYS(unlinkat),
    SCMP_SYS(rename),    SCMP_SYS(renameat), SCMP_SYS(renameat2), SCMP_SYS(truncate),
    SCMP_SYS(ftruncate), SCMP_SYS(mkdir),    SCMP_SYS(mkdirat),   SCMP_SYS(rmdir),
    SCMP_SYS(link),      SCMP_SYS(linkat),   SCMP_SYS(symlink),   SCMP_SYS(symlinkat),
    SCMP_SYS(mknod),     SCMP_SYS(mknodat),  SCMP_SYS(chmod),     SCMP_SYS(fchmod),
    SCMP_SYS(fchmodat),  SCMP_SYS(chown),    SCMP_SYS(fchownat),  SCMP_SYS(utimensat)};

CallFilter build_sanitizer_filter() {
  const Context context = new_context(SCMP_ACT_ALLOW);
  for (const auto* calls :
       {&others_processes, &shared_objects, &network, &rights, &changes_of_files})
    deny(context, *calls, EPERM);
  for (const int change : {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC}) {
    const auto bit = static_cast<std::uint64_t>(change);
    add_rule(context, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(open), {has(1, bit)});
    add_rule(context, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(openat), {has(2, bit)});
  }
  // A file that is ready, or changed, sends a signal to whom its owner names.
  for (const int command : {F_SETOWN, F_SETOWN_EX, F_SETSIG, F_SETLEASE, F_NOTIFY})
    add_rule(context, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(fcntl),
             {{1, SCMP_CMP_EQ, static_cast<std::uint64_t>(command), 0}});
  for (const int request : {FIOSETOWN, SIOCSPGRP, FIOASYNC, TIOCSTI})
    add_rule(context, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(ioctl),
             {{1, SCMP_CMP_EQ, static_cast<std::uint64_t>(request), 0}});
  deny(context, {SCMP_SYS(clone3)},
       ENOSYS);  // then the C library uses clone, whose flags can be seen
  add_rule(context, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(prlimit64), {{0, SCMP_CMP_NE, 0, 0}});
  add_rule(context, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(clone), {lacks(0, CLONE_THREAD)});
  add_rule(context, SCMP_ACT_ERRNO(EPERM), SCMP_SYS(execve), {{0, SCMP_CMP_NE, path_address, 0}});
  return exported(context);
}

}  // namespace

const CallFilter& call_filter(CallRules rules) {
  static const CallFilter none;
  if (!call_filters_available()) return none;  // missing_walls() says so
  static const CallFilter worker = build_worker_filter();
  static const CallFilter sanitizer = build_sanitizer_filter();
  switch (rules) {
    case CallRules::all:
      break;
    case CallRules::worker:
      return worker;
    case CallRules::sanitizer:
      return sanitizer;
  }
  return none;
}

bool call_filters_available() {
  // seccomp(2): a kernel that has filters looks for the program, and finds none there.
  static const bool available =
      prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, nullptr) != 0 && errno == EFAULT;
  return available;
}

bool install_call_filter(const CallFilter& filter) {
  // The kernel only reads the program, whatever the type of the pointer says.
  const sock_fprog program = {
      static_cast<unsigned short>(filter.size()),
      reinterpret_cast<sock_filter*>(const_cast<std::uint64_t*>(filter.data()))};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0;
}

void prepare_path(const std::string& path) {
  if (path.size() + 1 > path_capacity) throw std::runtime_error("this path is too long: " + path);
  std::memcpy(path_page(), path.c_str(), path.size() + 1);
}

void execute_behind_filter(const char* const argv[], const char* const environment[]) {
  syscall(SYS_execve, path_address, argv, environment);
}

std::string name_of_call(int number) {
  const std::unique_ptr<char, decltype(&std::free)> name(
      seccomp_syscall_resolve_num_arch(SCMP_ARCH_NATIVE, number), std::free);
  return name ? name.get() : "system call " + std::to_string(number);
}

bool is_abort(int number) { return number == SYS_tgkill; }

std::string purpose_of_call(int number) {
  static const std::map<std::string, std::string> purposes{
      {"open", "open a file"},
      {"openat", "open a file"},
      {"openat2", "open a file"},
      {"creat", "open a file"},
      {"unlink", "delete a file"},
      {"unlinkat", "delete a file"},
      {"access", "look for a file"},
      {"faccessat2", "look for a file"},
      {"newfstatat", "look for a file"},
      {"stat", "look for a file"},
      {"getcwd", "look for a file"},
      {"socket", "open a network connection"},
      {"socketpair", "open a network connection"},
      {"connect", "open a network connection"},
      {"clone", "start a thread or a process"},
      {"clone3", "start a thread or a process"},
      {"fork", "start a process"},
      {"vfork", "start a process"},
      {"execve", "start another program"},
      {"execveat", "start another program"},
      {"ptrace", "look into another process"},
      {"process_vm_readv", "look into another process"},
      {"process_vm_writev", "look into another process"},
      {"pidfd_open", "look into another process"},
      {"kill", "send a signal to a process"},
      {"tkill", "send a signal to a process"},
      {"nanosleep", "sleep"},
      {"clock_nanosleep", "sleep"},
      {"pause", "sleep"},
      {"close", "close a file that is not its own"},
      {"dup", "copy an open file"},
      {"dup2", "copy an open file"},
      {"dup3", "copy an open file"},
      {"mmap", "map memory that can be executed or at an address of its choice"},
      {"mprotect", "make memory executable"}};
  const auto known = purposes.find(name_of_call(number));
  return known != purposes.end() ? known->second : "ask the operating system";
}

}  // namespace tumble::judge
