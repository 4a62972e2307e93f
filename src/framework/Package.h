#pragma once
#include <vector>

#include "framework/Representation.h"

namespace gt {

class Process;

/// The remote end of a sender's connection: a receiver in the same program, or a connection to one
/// in another program.
class PackageLink {
 public:
  virtual ~PackageLink() = default;
  /// Whether the receiver has taken the last package and requested a new one.
  virtual bool requested() const = 0;
  /// Whether a package can be delivered; it replaces one that was not taken yet. False while the
  /// receiver's process executes main().
  virtual bool accepts() const = 0;
  /// False while the receiver is absent, because its program has ended. Senders do not wait for an
  /// absent receiver.
  virtual bool active() const { return true; }
  /// Delivers a package. There is no queueing (report 2.2.3.1).
  virtual void deliver(const void* package) = 0;
};

/// Sends a package, which is stored elsewhere, to all connected receivers (report C.3.2). Packages
/// are not buffered: each transfer contains the package as it is at that moment.
class PackageSender {
 public:
  PackageSender(const RepresentationType& type, const void* package, bool blocking = false)
      : type_{&type}, package_{package}, blocking_{blocking} {}
  PackageSender(const PackageSender&) = delete;
  PackageSender& operator=(const PackageSender&) = delete;

  void connect(PackageLink& link) { links_.push_back({&link}); }
  /// Transfers the package immediately to all receivers that requested it, and marks it as to be
  /// sent to the others.
  void send();
  /// Phase 3: transfers the package to marked receivers that accept it now.
  void sendLater();
  /// Whether at least one receiver requested a new package.
  bool requestedNew() const;
  /// Whether the process need not wait for this sender: a blocking sender waits until all receivers
  /// that are present have requested.
  bool ready() const;
  /// Whether the sender can start a cycle: it blocks, and at least one receiver is present.
  bool triggers() const;
  const RepresentationType& type() const { return *type_; }

 private:
  struct Link {
    PackageLink* receiver;
    bool toBeSent = false;
  };

  const RepresentationType* type_;
  const void* package_;
  bool blocking_;
  std::vector<Link> links_;
};

/// Receives packages into memory that is owned elsewhere (report C.3.3).
class PackageReceiver : public PackageLink {
 public:
  PackageReceiver(const RepresentationType& type, void* package, bool blocking = false)
      : type_{&type}, package_{package}, incoming_{type.make()}, blocking_{blocking} {}
  PackageReceiver(const PackageReceiver&) = delete;
  PackageReceiver& operator=(const PackageReceiver&) = delete;

  bool requested() const override { return !arrived_ && !busy_; }
  bool accepts() const override { return !busy_; }
  void deliver(const void* package) override {
    if (package != incoming_.get()) type_->copy(package, incoming_.get());
    arrived_ = true;
  }
  /// The memory for the next package. A package that is written there and then delivered from there
  /// is not copied. Valid until the next receive().
  void* place() { return incoming_.get(); }
  /// Delivers a package as bytes. A package that cannot be read is dropped.
  Result<void> deliverBytes(std::span<const std::byte> bytes) {
    const auto done = type_->decode(bytes, incoming_.get());
    arrived_ = static_cast<bool>(done);
    return done;
  }
  /// Phase 1: takes the arrived package, if any.
  void receive() {
    received_ = arrived_;
    if (arrived_) type_->swap(package_, incoming_.get());
    arrived_ = false;
    busy_ = true;
  }
  /// Requests the next package after main() has finished.
  void request() { busy_ = false; }
  /// Whether this cycle began with a new package.
  bool receivedNew() const { return received_; }
  bool ready() const { return !blocking_ || arrived_; }
  bool blocking() const { return blocking_; }
  const RepresentationType& type() const { return *type_; }

 private:
  const RepresentationType* type_;
  void* package_;
  std::shared_ptr<void> incoming_;
  bool blocking_;
  bool arrived_ = false;
  bool busy_ = false;
  bool received_ = false;
};

namespace detail {
void registerIn(Process& process, PackageSender& sender);
void registerIn(Process& process, PackageReceiver& receiver);
}  // namespace detail

/// A sender of a custom process that also is its package: `Sender<NumberPackage> numbers{*this};`
template <typename T>
class Sender : public T, public PackageSender {
 public:
  explicit Sender(Process& process, bool blocking = false)
      : PackageSender{representation<T>(), static_cast<const T*>(this), blocking} {
    detail::registerIn(process, *this);
  }
};

/// A receiver of a custom process that also is its package:
/// `Receiver<NumberPackage> numbers{*this, true};`
template <typename T>
class Receiver : public T, public PackageReceiver {
 public:
  explicit Receiver(Process& process, bool blocking = false)
      : PackageReceiver{representation<T>(), static_cast<T*>(this), blocking} {
    detail::registerIn(process, *this);
  }
};

}  // namespace gt
