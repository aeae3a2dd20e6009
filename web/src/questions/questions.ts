/** All that is asked by one page. */
export class Questions {
  private readonly open = new Set<object>();

  /** Nothing is on its way, or waits until it is worth asking, but what is asked at leisure. */
  settled(): boolean {
    return this.open.size === 0;
  }
  begin(asked: object): void {
    this.open.add(asked);
  }
  end(asked: object): void {
    this.open.delete(asked);
  }
}
