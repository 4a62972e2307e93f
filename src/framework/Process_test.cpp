#include "framework/Process.h"

#include <gtest/gtest.h>

#include "framework/RepresentationDefinition.h"

namespace gt {
namespace {

struct NumberPackage {
  int number = 0;

  static constexpr auto fields() { return Fields{field<&NumberPackage::number>()}; }
};

/// Example1 of report C.3.2.
class Example1 : public Process {
 public:
  explicit Example1(bool blocking = false) : Process{"Example1"}, numbers{*this, blocking} {}
  Sender<NumberPackage> numbers;

 protected:
  int main() override {
    ++numbers.number;
    numbers.send();
    return 100;
  }
};

/// Example2 of report C.3.3.
class Example2 : public Process {
 public:
  explicit Example2(bool blocking = true) : Process{"Example2"}, numbers{*this, blocking} {}
  Receiver<NumberPackage> numbers;
  std::vector<int> printed;

 protected:
  int main() override {
    printed.push_back(numbers.number);
    return 0;
  }
};

class Counter : public Process {
 public:
  explicit Counter(int wait) : Process{"Counter"}, wait_{wait} {}
  int count = 0;

 protected:
  int main() override {
    ++count;
    return wait_;
  }

 private:
  int wait_;
};

/// A clock and a process whose main() takes time on it.
struct Worker : Process {
  explicit Worker(int value) : Process{"Worker"}, wait{value} {}
  /// The begins of all cycles until a time, on a platform that looks every millisecond.
  std::vector<std::int64_t> beginsUntil(std::int64_t end) {
    while (time.ms < end) {
      stepBy([this] { return time; });
      time = time + 1;
    }
    return begins;
  }

  int wait;
  Time time;
  int work = 100;
  std::vector<std::int64_t> begins;

 protected:
  int main() override {
    begins.push_back(now().ms);
    time = time + work;
    return wait;
  }
};

/// "if main() itself requires 100 ms of processing time, and then pauses for 500 ms before it is
/// recalled, it will in fact be called every 600 ms"
TEST(Process, PositiveValueIsPauseAfterMain) {
  EXPECT_EQ(Worker{500}.beginsUntil(1900), (std::vector<std::int64_t>{0, 600, 1200, 1800}));
}

/// "-500 will ensure a cycle time of 500 ms, as long as main() itself does not require more"
TEST(Process, NegativeValueIsCycleTime) {
  EXPECT_EQ(Worker{-500}.beginsUntil(1900), (std::vector<std::int64_t>{0, 500, 1000, 1500}));
}

TEST(Process, MainThatTakesLongerThanItsCycleIsCalledAgainAtOnce) {
  Worker worker{-500};
  worker.work = 700;
  EXPECT_EQ(worker.beginsUntil(2000), (std::vector<std::int64_t>{0, 701, 1402}));
}

TEST(Process, CycleTimeDoesNotDriftIfCallsComeLate) {
  Counter counter{-500};
  for (int ms = 0; ms < 100'000; ms += 8) counter.step({ms});
  EXPECT_EQ(counter.count, 200);
}

TEST(Process, ZeroWithoutBlockingReceiverRunsOnce) {
  Counter counter{0};
  for (int ms = 0; ms < 1000; ms += 8) counter.step({ms});
  EXPECT_EQ(counter.count, 1);
}

/// "main() will wait for all blocking objects before it starts": a blocking sender recalls a
/// process that returns 0 when it was asked for a new package.
TEST(Process, ZeroIsRecalledByABlockingSender) {
  class Supplier : public Example1 {
   public:
    Supplier() : Example1{true} {}

   protected:
    int main() override {
      Example1::main();
      return 0;
    }
  } supplier;
  Example2 consumer;
  supplier.numbers.connect(consumer.numbers);
  for (int ms = 0; ms < 5; ++ms) EXPECT_EQ(supplier.step({ms}), ms == 0);
  consumer.step({5});
  EXPECT_TRUE(supplier.step({6}));
  consumer.step({7});
  EXPECT_EQ(consumer.printed, (std::vector<int>{1, 2}));
}

TEST(Process, BlockingReceiverAlwaysPrintsANewNumber) {
  Example1 sender;
  Example2 receiver;
  sender.numbers.connect(receiver.numbers);
  for (int ms = 0; ms < 350; ms += 10) {
    sender.step({ms});
    receiver.step({ms});
  }
  EXPECT_EQ(receiver.printed, (std::vector<int>{1, 2, 3, 4}));
}

TEST(Process, NonBlockingReceiverMayHoldTheSamePackageForSeveralCycles) {
  Example1 sender;
  class Poller : public Example2 {
   public:
    Poller() : Example2{false} {}
    int fresh = 0;

   protected:
    int main() override {
      fresh += numbers.receivedNew();
      Example2::main();
      return 10;
    }
  } receiver;
  sender.numbers.connect(receiver.numbers);
  for (int ms = 0; ms < 50; ms += 10) {
    sender.step({ms});
    receiver.step({ms});
  }
  EXPECT_EQ(receiver.printed, (std::vector<int>{1, 1, 1, 1, 1}));
  EXPECT_EQ(receiver.fresh, 1);
}

TEST(Process, SlowReceiverGetsTheNewestPackage) {
  Example1 sender;
  Example2 receiver;
  sender.numbers.connect(receiver.numbers);
  for (int ms = 0; ms < 300; ms += 100) sender.step({ms});
  receiver.step({300});
  EXPECT_EQ(receiver.printed, (std::vector<int>{3}));
}

TEST(Process, RequestedNewNeedsOneReceiverBlockingSenderAll) {
  Example1 sender{true};
  Example2 fast, slow;
  sender.numbers.connect(fast.numbers);
  sender.numbers.connect(slow.numbers);
  EXPECT_TRUE(sender.step({0}));
  EXPECT_FALSE(sender.numbers.requestedNew());
  fast.step({0});
  EXPECT_TRUE(sender.numbers.requestedNew());
  EXPECT_FALSE(sender.step({100})) << "waits until all receivers requested";
  slow.step({100});
  EXPECT_TRUE(sender.step({100}));
}

/// The far end of a connection, as another program would be.
struct FarEnd : PackageLink {
  bool requested() const override { return wants; }
  bool accepts() const override { return wants; }
  void deliver(const void* package) override {
    received.push_back(static_cast<const NumberPackage*>(package)->number);
    wants = false;
  }
  bool wants = true;
  std::vector<int> received;
};

/// A process whose main() is given by the test.
struct Custom : Process {
  Custom() : Process{"Custom"} {}
  int main() override {
    work();
    return 10;
  }
  std::function<void()> work;
};

/// "send() marks the package as to be sent and will immediately send it to all receivers that have
/// requested a package."
TEST(Sender, SendsAtOnceToWhoRequested) {
  Custom process;
  Sender<NumberPackage> numbers{process};
  FarEnd far;
  numbers.connect(far);
  process.work = [&] {
    numbers.number = 1;
    numbers.send();
    EXPECT_EQ(far.received, (std::vector<int>{1})) << "while main() still runs";
    numbers.number = 2;
  };
  process.step(Time{0});
  EXPECT_EQ(far.received, (std::vector<int>{1})) << "once only";
}

/// "each time the function main() has terminated, the package will be sent to all receivers that
/// have requested it later and have not got it yet. [...] always the actual content of a package
/// will be transmitted, even if it changed since the last call to send()."
TEST(Sender, SendsLaterWhatThePackageIsThen) {
  Custom process;
  Sender<NumberPackage> numbers{process};
  FarEnd prompt, late;
  late.wants = false;
  numbers.connect(prompt);
  numbers.connect(late);
  process.work = [&] {
    numbers.number = 1;
    numbers.send();
    numbers.number = 2;
  };
  process.step(Time{0});
  EXPECT_EQ(late.received, (std::vector<int>{}));
  process.work = [&] { numbers.number = 3; };
  late.wants = true;
  process.step(Time{10});
  EXPECT_EQ(prompt.received, (std::vector<int>{1}));
  EXPECT_EQ(late.received, (std::vector<int>{3})) << "sent, though send() was not called again";
  late.wants = true;
  process.step(Time{20});
  EXPECT_EQ(late.received, (std::vector<int>{3})) << "it has got it";
}

/// "Packages must always explicitly be sent"
TEST(Sender, SendsNothingByItself) {
  Custom process;
  Sender<NumberPackage> numbers{process};
  FarEnd far;
  numbers.connect(far);
  process.work = [] {};
  process.step(Time{0});
  EXPECT_TRUE(far.received.empty());
  EXPECT_TRUE(numbers.requestedNew());
}

/// "A receiver obtains a package before the function main() starts and will request for the next
/// package after main() was finished."
TEST(Receiver, RequestsTheNextPackageAfterMain) {
  Custom source, process;
  Sender<NumberPackage> numbers{source};
  Receiver<NumberPackage> received{process};
  numbers.connect(received);
  source.work = [&] {
    ++numbers.number;
    numbers.send();
  };
  source.step(Time{0});
  EXPECT_EQ(received.number, 0) << "obtained before main(), not when it was sent";
  process.work = [&] {
    EXPECT_EQ(received.number, 1);
    EXPECT_FALSE(numbers.requestedNew());
    source.step(Time{10});
    EXPECT_EQ(received.number, 1) << "constant while main() runs";
  };
  process.step(Time{10});
  EXPECT_TRUE(numbers.requestedNew());
  process.work = [&] { EXPECT_FALSE(received.receivedNew()) << "missed: sent before requested"; };
  process.step(Time{20});
  process.work = [&] { EXPECT_EQ(received.number, 3); };
  source.step(Time{20});
  process.step(Time{30});
}

/// "the non-blocking receivers shall be defined first. Otherwise, the packages of the non-blocking
/// receivers may be older": here the order does not matter, all receive when the cycle begins.
TEST(Receiver, HoldsTheNewestWhereverItIsDefined) {
  Custom source, process;
  Sender<NumberPackage> numbers{source};
  Receiver<NumberPackage> before{process}, blocking{process, true}, after{process};
  numbers.connect(before);
  numbers.connect(after);
  Custom trigger;
  Sender<NumberPackage> triggers{trigger};
  triggers.connect(blocking);
  source.work = [&] {
    ++numbers.number;
    numbers.send();
  };
  trigger.work = [&] { triggers.send(); };
  int cycles = 0;
  process.work = [&] {
    ++cycles;
    EXPECT_EQ(before.number, 3);
    EXPECT_EQ(after.number, 3);
  };
  for (int ms = 0; ms < 30; ms += 10) {
    source.step(Time{ms});
    process.step(Time{ms});
  }
  trigger.step(Time{30});
  process.step(Time{30});
  EXPECT_EQ(cycles, 1) << "it waits for the blocking one";
}

/// "The only possibility to ensure that a receiver will get a package is to only send it, when it
/// already has been requested": by requestedNew() here.
TEST(Sender, NothingIsMissedIfSentOnlyWhenRequested) {
  Custom source;
  Sender<NumberPackage> numbers{source};
  Example2 slow;
  numbers.connect(slow.numbers);
  source.work = [&] {
    if (!numbers.requestedNew()) return;
    ++numbers.number;
    numbers.send();
  };
  for (int ms = 0; ms < 100; ++ms) {
    source.step({ms});
    if (ms % 30 == 0) slow.step({ms});
  }
  EXPECT_EQ(slow.printed, (std::vector<int>{1, 2, 3, 4}));
}

TEST(Receiver, SeveralReceiversOfOneSenderGetItEachInItsOwnTime) {
  Example1 sender;
  Example2 first, second;
  sender.numbers.connect(first.numbers);
  sender.numbers.connect(second.numbers);
  for (int ms = 0; ms < 500; ms += 10) {
    sender.step({ms});
    first.step({ms});
    if (ms % 250 == 0) second.step({ms});
  }
  EXPECT_EQ(first.printed, (std::vector<int>{1, 2, 3, 4, 5}));
  EXPECT_EQ(second.printed, (std::vector<int>{1, 3})) << "the newest each";
}

}  // namespace
}  // namespace gt
