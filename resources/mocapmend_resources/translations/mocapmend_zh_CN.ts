<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN" sourcelanguage="en">
<context>
    <name>Actions</name>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Export repaired recording…</source>
        <translation>导出修复后的记录…</translation>
    </message>
    <message>
        <source>Save report…</source>
        <translation>保存报告…</translation>
    </message>
    <message>
        <source>Check a repaired copy…</source>
        <translation>检查修复副本…</translation>
    </message>
    <message>
        <source>Save recipe…</source>
        <translation>保存修复方案…</translation>
    </message>
    <message>
        <source>Replay recipe…</source>
        <translation>重放修复方案…</translation>
    </message>
    <message>
        <source>Close file</source>
        <translation>关闭文件</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>退出</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>Select all markers</source>
        <translation>选择全部标记点</translation>
    </message>
    <message>
        <source>Select no marker</source>
        <translation>取消选择标记点</translation>
    </message>
    <message>
        <source>Next gap</source>
        <translation>下一个缺失段</translation>
    </message>
    <message>
        <source>Previous gap</source>
        <translation>上一个缺失段</translation>
    </message>
    <message>
        <source>Next gap of this marker</source>
        <translation>此标记点的下一个缺失段</translation>
    </message>
    <message>
        <source>Previous gap of this marker</source>
        <translation>此标记点的上一个缺失段</translation>
    </message>
    <message>
        <source>Leave this gap open</source>
        <translation>保留此缺失段不填补</translation>
    </message>
    <message>
        <source>Never fill this gap</source>
        <translation>永不填补此缺失段</translation>
    </message>
    <message>
        <source>Cut a frame off both edges of the gap</source>
        <translation>缺失段两端各多切除一帧</translation>
    </message>
    <message>
        <source>Give a frame back at both edges</source>
        <translation>缺失段两端各还回一帧</translation>
    </message>
    <message>
        <source>Apply the previewed repair</source>
        <translation>应用预览的修复</translation>
    </message>
    <message>
        <source>Apply and go to the next gap</source>
        <translation>应用并转到下一个缺失段</translation>
    </message>
    <message>
        <source>Turn this repair back into a gap</source>
        <translation>将此修复还原为缺失段</translation>
    </message>
    <message>
        <source>Choose repair {0}</source>
        <translation>选择修复 {0}</translation>
    </message>
    <message>
        <source>Choose repair</source>
        <translation>选择修复</translation>
    </message>
    <message>
        <source>Next method</source>
        <translation>下一种方法</translation>
    </message>
    <message>
        <source>Previous method</source>
        <translation>上一种方法</translation>
    </message>
    <message>
        <source>Compare repairs side by side</source>
        <translation>并列比较各种修复</translation>
    </message>
    <message>
        <source>Pick donors by clicking markers</source>
        <translation>点击标记点以选取参考标记点</translation>
    </message>
    <message>
        <source>Plan for all gaps</source>
        <translation>全部缺失段的填补计划</translation>
    </message>
    <message>
        <source>Save plan…</source>
        <translation>保存计划…</translation>
    </message>
    <message>
        <source>Load plan…</source>
        <translation>载入计划…</translation>
    </message>
    <message>
        <source>Fill all gaps up to the limit</source>
        <translation>填补限值内的全部缺失段</translation>
    </message>
    <message>
        <source>Play / pause</source>
        <translation>播放 / 暂停</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>下一帧</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>上一帧</translation>
    </message>
    <message>
        <source>One second forward</source>
        <translation>前进一秒</translation>
    </message>
    <message>
        <source>One second back</source>
        <translation>后退一秒</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>第一帧</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>最后一帧</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>加快</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>减慢</translation>
    </message>
    <message>
        <source>Next event</source>
        <translation>下一个事件</translation>
    </message>
    <message>
        <source>Previous event</source>
        <translation>上一个事件</translation>
    </message>
    <message>
        <source>Select from here</source>
        <translation>从此处开始选择</translation>
    </message>
    <message>
        <source>Select to here</source>
        <translation>选择到此处</translation>
    </message>
    <message>
        <source>Select none</source>
        <translation>取消选择</translation>
    </message>
    <message>
        <source>Loop the selection, or everything</source>
        <translation>循环播放所选范围或全部</translation>
    </message>
    <message>
        <source>Front view</source>
        <translation>前视图</translation>
    </message>
    <message>
        <source>Look from</source>
        <translation>视角</translation>
    </message>
    <message>
        <source>Back view</source>
        <translation>后视图</translation>
    </message>
    <message>
        <source>Left view</source>
        <translation>左视图</translation>
    </message>
    <message>
        <source>Right view</source>
        <translation>右视图</translation>
    </message>
    <message>
        <source>Top view</source>
        <translation>俯视图</translation>
    </message>
    <message>
        <source>Oblique view</source>
        <translation>斜视图</translation>
    </message>
    <message>
        <source>Look from further left</source>
        <translation>视角左移</translation>
    </message>
    <message>
        <source>Look from further right</source>
        <translation>视角右移</translation>
    </message>
    <message>
        <source>Look from higher up</source>
        <translation>视角升高</translation>
    </message>
    <message>
        <source>Look from lower down</source>
        <translation>视角降低</translation>
    </message>
    <message>
        <source>Nearer</source>
        <translation>拉近</translation>
    </message>
    <message>
        <source>Farther</source>
        <translation>拉远</translation>
    </message>
    <message>
        <source>Centre the current marker</source>
        <translation>以当前标记点为中心</translation>
    </message>
    <message>
        <source>Follow the body</source>
        <translation>跟随人体</translation>
    </message>
    <message>
        <source>Show in 3D</source>
        <translation>三维显示内容</translation>
    </message>
    <message>
        <source>Marker labels</source>
        <translation>标记点名称</translation>
    </message>
    <message>
        <source>Trail of the selection</source>
        <translation>所选标记点的尾迹</translation>
    </message>
    <message>
        <source>Trails of all markers</source>
        <translation>全部标记点的尾迹</translation>
    </message>
    <message>
        <source>Longer trails</source>
        <translation>加长尾迹</translation>
    </message>
    <message>
        <source>Shorter trails</source>
        <translation>缩短尾迹</translation>
    </message>
    <message>
        <source>Sticks</source>
        <translation>连线</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>节段</translation>
    </message>
    <message>
        <source>Ground grid</source>
        <translation>地面网格</translation>
    </message>
    <message>
        <source>Force plates</source>
        <translation>测力台</translation>
    </message>
    <message>
        <source>Before and after the edits</source>
        <translation>编辑前后对比</translation>
    </message>
    <message>
        <source>Measure the selection</source>
        <translation>测量所选标记点</translation>
    </message>
    <message>
        <source>Zoom in on the time axis</source>
        <translation>放大时间轴</translation>
    </message>
    <message>
        <source>Zoom out on the time axis</source>
        <translation>缩小时间轴</translation>
    </message>
    <message>
        <source>Whole recording</source>
        <translation>整段记录</translation>
    </message>
    <message>
        <source>Zoom to the gap</source>
        <translation>缩放到缺失段</translation>
    </message>
    <message>
        <source>Zoom to the selected frames</source>
        <translation>缩放到所选帧</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>下一页</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>上一页</translation>
    </message>
    <message>
        <source>Lanes with most missing first</source>
        <translation>缺失最多的轨道在前</translation>
    </message>
    <message>
        <source>Go to the timeline</source>
        <translation>转到时间线</translation>
    </message>
    <message>
        <source>Go to pane</source>
        <translation>转到窗格</translation>
    </message>
    <message>
        <source>Go to the repairs</source>
        <translation>转到修复列表</translation>
    </message>
    <message>
        <source>Go to the report</source>
        <translation>转到报告</translation>
    </message>
    <message>
        <source>Go to the queue</source>
        <translation>转到队列</translation>
    </message>
    <message>
        <source>Go to the analog channels</source>
        <translation>转到模拟通道</translation>
    </message>
    <message>
        <source>Go to the history</source>
        <translation>转到历史</translation>
    </message>
    <message>
        <source>Next recording</source>
        <translation>下一个记录</translation>
    </message>
    <message>
        <source>Previous recording</source>
        <translation>上一个记录</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>跟随系统</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>主题</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>浅色</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>深色</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>语言 (Language)</translation>
    </message>
    <message>
        <source>English</source>
        <translation>English</translation>
    </message>
    <message>
        <source>中文</source>
        <translation>中文</translation>
    </message>
    <message>
        <source>Larger</source>
        <translation>放大</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>文字大小</translation>
    </message>
    <message>
        <source>Smaller</source>
        <translation>缩小</translation>
    </message>
    <message>
        <source>Normal</source>
        <translation>正常</translation>
    </message>
    <message>
        <source>Save this layout…</source>
        <translation>保存当前布局…</translation>
    </message>
    <message>
        <source>Layouts</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Arrange as at first</source>
        <translation>恢复初始布局</translation>
    </message>
    <message>
        <source>Next set of plots</source>
        <translation>下一组曲线</translation>
    </message>
    <message>
        <source>Previous set of plots</source>
        <translation>上一组曲线</translation>
    </message>
    <message>
        <source>Position: x, y and z</source>
        <translation>位置：x、y 和 z</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Bone length</source>
        <translation>骨段长度</translation>
    </message>
    <message>
        <source>Next bone of the marker</source>
        <translation>此标记点的下一个骨段</translation>
    </message>
    <message>
        <source>Same scale for x, y and z</source>
        <translation>x、y、z 使用相同比例</translation>
    </message>
    <message>
        <source>One set of plots per marker</source>
        <translation>每个标记点一组曲线</translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Find an action…</source>
        <translation>查找命令…</translation>
    </message>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>Show the log file</source>
        <translation>显示日志文件</translation>
    </message>
    <message>
        <source>About mocapmend</source>
        <translation>关于 mocapmend</translation>
    </message>
</context>
<context>
    <name>AnalogPane</name>
    <message>
        <source>Filter channels</source>
        <translation>筛选通道</translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation>叠加</translation>
    </message>
    <message>
        <source>All channels in one plot</source>
        <translation>所有通道画在一个图中</translation>
    </message>
    <message>
        <source>Analog channels</source>
        <translation>模拟通道</translation>
    </message>
    <message>
        <source>Reading analog channels</source>
        <translation>正在读取模拟通道</translation>
    </message>
    <message>
        <source>The analog channels could not be read</source>
        <translation>无法读取模拟通道</translation>
    </message>
    <message>
        <source>Cancelled: check a channel to read it again</source>
        <translation>已取消：勾选通道可重新读取</translation>
    </message>
</context>
<context>
    <name>AnalogPlots</name>
    <message>
        <source>Analog plots</source>
        <translation>模拟通道曲线</translation>
    </message>
    <message>
        <source>Check a channel on the left to see it</source>
        <translation>在左侧勾选要显示的通道</translation>
    </message>
    <message>
        <source>Reading…</source>
        <translation>正在读取…</translation>
    </message>
    <message>
        <source>The file&apos;s values of this channel are no numbers</source>
        <translation>文件中此通道的值不是数字</translation>
    </message>
    <message>
        <source>Frame {0} · {1} s</source>
        <translation>第 {0} 帧 · {1} s</translation>
    </message>
    <message>
        <source>Value</source>
        <translation>数值</translation>
    </message>
</context>
<context>
    <name>BonesPage</name>
    <message>
        <source>Length ({0})</source>
        <translation>长度 ({0})</translation>
    </message>
    <message>
        <source>Bone spread</source>
        <translation>骨段长度离散度</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>修复前</translation>
    </message>
    <message>
        <source>After</source>
        <translation>修复后</translation>
    </message>
    <message>
        <source>Repaired frames</source>
        <translation>已修复帧数</translation>
    </message>
    <message>
        <source>Spread of the bone lengths</source>
        <translation>骨段长度的离散度</translation>
    </message>
    <message>
        <source>Standard deviation of the length over its mean</source>
        <translation>长度的标准差除以平均值</translation>
    </message>
    <message>
        <source>measured (dashed)</source>
        <translation>测量值（虚线）</translation>
    </message>
    <message>
        <source>repaired (solid)</source>
        <translation>修复值（实线）</translation>
    </message>
</context>
<context>
    <name>Callout</name>
    <message>
        <source>Tour</source>
        <translation>导览</translation>
    </message>
    <message>
        <source>Skip the tour</source>
        <translation>跳过导览</translation>
    </message>
    <message>
        <source>Esc; Help &gt; Tour shows it again</source>
        <translation>Esc；可用“帮助 &gt; 导览”再次显示</translation>
    </message>
</context>
<context>
    <name>CandidateList</name>
    <message>
        <source>Key</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Repairs of the current gap</source>
        <translation>当前缺失段的各种修复</translation>
    </message>
    <message>
        <source>Not computed yet</source>
        <translation>尚未计算</translation>
    </message>
    <message>
        <source>Too little of the recording to test on</source>
        <translation>记录太短，无法测试</translation>
    </message>
    <message>
        <source>The least expected error of these</source>
        <translation>其中预期误差最小</translation>
    </message>
</context>
<context>
    <name>Check</name>
    <message>
        <source>Changed marker</source>
        <translation>更改的标记点</translation>
    </message>
    <message>
        <source>First frame</source>
        <translation>首帧</translation>
    </message>
    <message>
        <source>Last frame</source>
        <translation>末帧</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧数</translation>
    </message>
    <message>
        <source>Check of {0}</source>
        <translation>检查 {0}</translation>
    </message>
    <message>
        <source>Original: {0}&lt;br&gt;Copy: {1}</source>
        <translation>原文件：{0}&lt;br&gt;副本：{1}</translation>
    </message>
    <message>
        <source>These differences are allowed:</source>
        <translation>以下差异是允许的：</translation>
    </message>
    <message>
        <source>These are not:</source>
        <translation>以下差异不允许：</translation>
    </message>
    <message>
        <source>and {0} more</source>
        <translation>另有 {0} 项</translation>
    </message>
</context>
<context>
    <name>Dialogs</name>
    <message>
        <source>Something went wrong inside the program. Your recording is unchanged.</source>
        <translation>程序内部出错。您的记录没有改变。</translation>
    </message>
    <message>
        <source>The log file has the details:</source>
        <translation>详细信息见日志文件：</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Why it stayed open</source>
        <translation>未填补的原因</translation>
    </message>
    <message>
        <source>Gaps that stayed open</source>
        <translation>未填补的缺失段</translation>
    </message>
    <message>
        <source>Double-click a gap to go there</source>
        <translation>双击缺失段可转到该处</translation>
    </message>
</context>
<context>
    <name>Documents</name>
    <message>
        <source>Open recordings</source>
        <translation>打开的记录</translation>
    </message>
</context>
<context>
    <name>EventLane</name>
    <message>
        <source>Event without a name</source>
        <translation>未命名事件</translation>
    </message>
    <message>
        <source>{0} {1}</source>
        <comment>side, event</comment>
        <translation>{0} {1}</translation>
    </message>
    <message>
        <source>Events</source>
        <translation>事件</translation>
    </message>
</context>
<context>
    <name>FileActions</name>
    <message>
        <source>Open recordings</source>
        <translation>打开记录</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>{0} is open already.</source>
        <translation>{0} 已经打开。</translation>
    </message>
    <message>
        <source>Opening {0}</source>
        <translation>正在打开 {0}</translation>
    </message>
    <message>
        <source>C3D (*.c3d)</source>
        <translation>C3D (*.c3d)</translation>
    </message>
    <message>
        <source>TRC (*.trc)</source>
        <translation>TRC (*.trc)</translation>
    </message>
    <message>
        <source>CSV, one line per frame (*.csv)</source>
        <translation>CSV，每帧一行 (*.csv)</translation>
    </message>
    <message>
        <source>CSV, one line per sample (*.long.csv)</source>
        <translation>CSV，每个采样一行 (*.long.csv)</translation>
    </message>
    <message>
        <source>NumPy (*.npz)</source>
        <translation>NumPy (*.npz)</translation>
    </message>
    <message>
        <source>Export repaired recording</source>
        <translation>导出修复后的记录</translation>
    </message>
    <message>
        <source>Export a truncated recording?</source>
        <translation>要导出截断的记录吗？</translation>
    </message>
    <message>
        <source>The file ends before its data do. The copy will be as short as the original.</source>
        <translation>文件在数据结束之前就中断了。副本将与原文件一样短。</translation>
    </message>
    <message>
        <source>Exporting {0}</source>
        <translation>正在导出 {0}</translation>
    </message>
    <message>
        <source>HTML (*.html)</source>
        <translation>HTML (*.html)</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>Save report</source>
        <translation>保存报告</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>正在写入报告</translation>
    </message>
    <message>
        <source>Report written to {0}</source>
        <translation>报告已写入 {0}</translation>
    </message>
    <message>
        <source>{0} has repairs that are not exported yet.</source>
        <translation>{0} 有尚未导出的修复。</translation>
    </message>
    <message>
        <source>Replace {0}?</source>
        <translation>要替换 {0} 吗？</translation>
    </message>
    <message>
        <source>There is a file of this name.</source>
        <translation>已有同名文件。</translation>
    </message>
    <message>
        <source>Recordings ({0})</source>
        <translation>记录 ({0})</translation>
    </message>
    <message>
        <source>Opened {0}</source>
        <translation>已打开 {0}</translation>
    </message>
    <message>
        <source>Opened {0}, in which {3} gaps have been repaired before</source>
        <translation>已打开 {0}，其中 {3} 个缺失段此前已修复</translation>
    </message>
    <message>
        <source>Opened {0}, which is truncated: {1} of {2} frames are there</source>
        <translation>已打开 {0}，该文件被截断：{2} 帧中只有 {1} 帧</translation>
    </message>
    <message>
        <source>Exported {0} to {1}: {2} repaired samples, read back and compared.</source>
        <translation>已将 {0} 导出到 {1}：{2} 个修复采样，已回读并比对。</translation>
    </message>
    <message>
        <source>Exported {0} to {1}: {2} samples changed, all else is the same.</source>
        <translation>已将 {0} 导出到 {1}：{2} 个采样有改变，其余完全相同。</translation>
    </message>
    <message>
        <source>Exported {0} to {1}: the same as the original, byte for byte.</source>
        <translation>已将 {0} 导出到 {1}：与原文件逐字节相同。</translation>
    </message>
    <message>
        <source>Replace the original recording?</source>
        <translation>要替换原始记录吗？</translation>
    </message>
    <message>
        <source>{0} is the file that you opened. Its missing samples will be overwritten with the repairs, and the undo history ends here. A new name keeps both.</source>
        <translation>{0} 就是您打开的文件。其中缺失的采样将被修复值覆盖，撤销历史也到此为止。换一个文件名可以两者都保留。</translation>
    </message>
    <message>
        <source>Go on</source>
        <translation>继续</translation>
    </message>
</context>
<context>
    <name>Filling</name>
    <message>
        <source>Fill all gaps</source>
        <translation>填补全部缺失段</translation>
    </message>
    <message>
        <source>Cancelled: nothing was filled.</source>
        <translation>已取消：没有填补任何缺失段。</translation>
    </message>
    <message>
        <source>fill {0} gaps ({1})</source>
        <translation>填补 {0} 个缺失段 ({1})</translation>
    </message>
    <message>
        <source>{0} gaps filled, {1} left open.</source>
        <translation>已填补 {0} 个缺失段，{1} 个未填补。</translation>
    </message>
</context>
<context>
    <name>GapActions</name>
    <message>
        <source>No gap is left in the queue.</source>
        <translation>队列中没有缺失段了。</translation>
    </message>
    <message>
        <source>No gap is left to go to.</source>
        <translation>没有可以转到的缺失段了。</translation>
    </message>
    <message>
        <source>There is no preview to apply: choose a gap first (N).</source>
        <translation>没有可应用的预览：请先选择缺失段 (N)。</translation>
    </message>
    <message>
        <source>This method leaves the gap open; choose another (M).</source>
        <translation>此方法不填补该缺失段；请换一种方法 (M)。</translation>
    </message>
    <message>
        <source>fill {0} ({1})</source>
        <translation>填补 {0} ({1})</translation>
    </message>
    <message>
        <source>clear the repair of {0}</source>
        <translation>清除 {0} 的修复</translation>
    </message>
    <message>
        <source>There is no repair here.</source>
        <translation>此处没有修复。</translation>
    </message>
    <message>
        <source>The gap is open again.</source>
        <translation>该缺失段已恢复为未填补。</translation>
    </message>
    <message>
        <source>left open by hand</source>
        <translation>手动保留未填补</translation>
    </message>
    <message>
        <source>There is no gap here.</source>
        <translation>此处没有缺失段。</translation>
    </message>
    <message>
        <source>never fill {0} gaps</source>
        <translation>永不填补 {0} 个缺失段</translation>
    </message>
    <message>
        <source>allow to fill {0} gaps</source>
        <translation>允许填补 {0} 个缺失段</translation>
    </message>
    <message>
        <source>The ends of this gap go no further.</source>
        <translation>此缺失段的两端不能再移动。</translation>
    </message>
    <message>
        <source>move the ends of a gap of {0}</source>
        <translation>移动 {0} 缺失段的两端</translation>
    </message>
    <message>
        <source>There is no open gap here.</source>
        <translation>此处没有未填补的缺失段。</translation>
    </message>
</context>
<context>
    <name>HistoryPage</name>
    <message>
        <source>Nothing is edited yet. Edits are listed here.</source>
        <translation>尚无编辑。编辑会列在这里。</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Runs</source>
        <translation>连续段</translation>
    </message>
    <message>
        <source>Samples filled</source>
        <translation>已填补采样</translation>
    </message>
    <message>
        <source>Samples set missing</source>
        <translation>设为缺失的采样</translation>
    </message>
    <message>
        <source>State</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>History of edits</source>
        <translation>编辑历史</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>已撤销</translation>
    </message>
    <message>
        <source>done</source>
        <translation>已完成</translation>
    </message>
    <message>
        <source>{0} repairs that the file had when it was opened</source>
        <translation>文件打开时已有的 {0} 处修复</translation>
    </message>
    <message>
        <source>before</source>
        <translation>此前</translation>
    </message>
</context>
<context>
    <name>HistoryPane</name>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Click a step, or use the arrow keys, to go back or forward to it</source>
        <translation>点击步骤或使用方向键，可后退或前进到该步骤</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>打开时的状态</translation>
    </message>
    <message>
        <source>{0} (undone)</source>
        <translation>{0}（已撤销）</translation>
    </message>
    <message>
        <source>{0} ✔ exported</source>
        <translation>{0} ✔ 已导出</translation>
    </message>
</context>
<context>
    <name>JobIndicator</name>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
</context>
<context>
    <name>LanePainter</name>
    <message>
        <source>Speed ({0}/s)</source>
        <translation>速度 ({0}/s)</translation>
    </message>
    <message>
        <source>Acceleration ({0}/s²)</source>
        <translation>加速度 ({0}/s²)</translation>
    </message>
    <message>
        <source>Residual ({0})</source>
        <translation>残差 ({0})</translation>
    </message>
    <message>
        <source>Length {0} ({1})</source>
        <translation>长度 {0} ({1})</translation>
    </message>
    <message>
        <source>This file has no residuals</source>
        <translation>此文件没有残差</translation>
    </message>
    <message>
        <source>Select two markers to see how far they are apart</source>
        <translation>选择两个标记点可查看它们的距离</translation>
    </message>
</context>
<context>
    <name>Language</name>
    <message>
        <source>The language changes at the next start.</source>
        <translation>语言将在下次启动时更改。</translation>
    </message>
</context>
<context>
    <name>Layouts</name>
    <message>
        <source>Save this layout</source>
        <translation>保存当前布局</translation>
    </message>
    <message>
        <source>Name of the layout:</source>
        <translation>布局名称：</translation>
    </message>
    <message>
        <source>Layout saved: {0}</source>
        <translation>布局已保存：{0}</translation>
    </message>
    <message>
        <source>The layout {0} is of another version and does not fit: save it anew.</source>
        <translation>布局 {0} 来自其他版本，不适用：请重新保存。</translation>
    </message>
    <message>
        <source>Layout deleted: {0}</source>
        <translation>布局已删除：{0}</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
</context>
<context>
    <name>LimitsBox</name>
    <message>
        <source>length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Longest gap in frames</source>
        <translation>最长缺失段（帧）</translation>
    </message>
    <message>
        <source>expected error</source>
        <translation>预期误差</translation>
    </message>
    <message>
        <source>Largest expected error in mm</source>
        <translation>最大预期误差 (mm)</translation>
    </message>
    <message>
        <source> frames ({0} ms)</source>
        <translation> 帧 ({0} ms)</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Tools</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>About mocapmend</source>
        <translation>关于 mocapmend</translation>
    </message>
    <message>
        <source>Inspects and repairs optical motion-capture recordings.</source>
        <translation>检查并修复光学动作捕捉记录。</translation>
    </message>
    <message>
        <source>{0} markers · {1} frames · {2} Hz · {3} s · {4}</source>
        <translation>{0} 个标记点 · {1} 帧 · {2} Hz · {3} s · {4}</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>The window closes when the file is written.</source>
        <translation>文件写完后窗口将关闭。</translation>
    </message>
</context>
<context>
    <name>MarkerModel</name>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>缺失段</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>最长</translation>
    </message>
    <message>
        <source>{0}: never seen in this recording</source>
        <translation>{0}：在此记录中从未出现</translation>
    </message>
    <message>
        <source>{0}: {1} open gaps, longest {2} frames ({3} ms), {4} samples filled</source>
        <translation>{0}：{1} 个未填补的缺失段，最长 {2} 帧 ({3} ms)，已填补 {4} 个采样</translation>
    </message>
    <message>
        <source>Moves as one with {0}</source>
        <translation>与 {0} 作为整体运动</translation>
    </message>
</context>
<context>
    <name>MarkerReportModel</name>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Missing (%)</source>
        <translation>缺失 (%)</translation>
    </message>
    <message>
        <source>Frames in which it was missing before, in %</source>
        <translation>修复前缺失的帧所占百分比</translation>
    </message>
    <message>
        <source>now (%)</source>
        <translation>现在 (%)</translation>
    </message>
    <message>
        <source>Frames in which it is missing now, in %</source>
        <translation>现在缺失的帧所占百分比</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>缺失段</translation>
    </message>
    <message>
        <source>Gaps before</source>
        <translation>修复前的缺失段数</translation>
    </message>
    <message>
        <source>now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>Gaps now</source>
        <translation>现在的缺失段数</translation>
    </message>
    <message>
        <source>Longest</source>
        <translation>最长</translation>
    </message>
    <message>
        <source>Longest gap before, in frames</source>
        <translation>修复前最长的缺失段，以帧计</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Longest gap before, in milliseconds</source>
        <translation>修复前最长的缺失段，以毫秒计</translation>
    </message>
    <message>
        <source>Longest gap now, in frames</source>
        <translation>现在最长的缺失段，以帧计</translation>
    </message>
    <message>
        <source>Filled</source>
        <translation>已填补</translation>
    </message>
    <message>
        <source>Samples filled</source>
        <translation>已填补的采样数</translation>
    </message>
    <message>
        <source>Unfilled</source>
        <translation>未填补</translation>
    </message>
    <message>
        <source>Samples that are missing now</source>
        <translation>现在仍缺失的采样数</translation>
    </message>
    <message>
        <source>Filled by (%)</source>
        <translation>填补方法 (%)</translation>
    </message>
    <message>
        <source>Frames that each method filled, in %</source>
        <translation>每种方法填补的帧所占百分比</translation>
    </message>
    <message>
        <source>Error (mm)</source>
        <translation>误差 (mm)</translation>
    </message>
    <message>
        <source>Largest expected error of its repairs, in mm</source>
        <translation>其各处修复的最大预期误差 (mm)</translation>
    </message>
</context>
<context>
    <name>MarkerTable</name>
    <message>
        <source>Filter markers</source>
        <translation>筛选标记点</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
</context>
<context>
    <name>MarkersPage</name>
    <message>
        <source>Markers before and after the repairs</source>
        <translation>修复前后的标记点</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>Open recent</source>
        <translation>最近打开</translation>
    </message>
    <message>
        <source>Panes</source>
        <translation>窗格</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>文件(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>编辑(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Gaps</source>
        <translation>缺失段(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Repair</source>
        <translation>修复(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>播放(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>P&amp;lots</source>
        <translation>曲线(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>{0} (gone)</source>
        <translation>{0}（已不存在）</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>暂无</translation>
    </message>
    <message>
        <source>Remove files that are gone</source>
        <translation>移除已不存在的文件</translation>
    </message>
    <message>
        <source>Clear the list</source>
        <translation>清空列表</translation>
    </message>
    <message>
        <source>None without markers</source>
        <translation>没有标记点时无窗格</translation>
    </message>
</context>
<context>
    <name>MethodBox</name>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
</context>
<context>
    <name>MethodsPage</name>
    <message>
        <source>Methods paragraph</source>
        <translation>方法段落</translation>
    </message>
    <message>
        <source>Being computed…</source>
        <translation>正在计算…</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy the methods paragraph</source>
        <translation>复制方法段落</translation>
    </message>
    <message>
        <source>Ready to paste into a paper, in English.</source>
        <translation>可直接粘贴到论文中（英文）。</translation>
    </message>
    <message>
        <source>Copied.</source>
        <translation>已复制。</translation>
    </message>
</context>
<context>
    <name>NamesEdit</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>◀ selected</source>
        <translation>◀ 所选</translation>
    </message>
    <message>
        <source>Take the selected markers</source>
        <translation>取用所选标记点</translation>
    </message>
    <message>
        <source>Take the selected markers: {0}</source>
        <translation>取用所选标记点：{0}</translation>
    </message>
    <message>
        <source>To take markers, Ctrl+click them in the list.</source>
        <translation>要取用标记点，请在列表中按住 Ctrl 点击。</translation>
    </message>
</context>
<context>
    <name>NotesBar</name>
    <message>
        <source>1 note on this file</source>
        <translation>此文件有 1 条说明</translation>
    </message>
    <message>
        <source>{0} notes on this file</source>
        <translation>此文件有 {0} 条说明</translation>
    </message>
    <message>
        <source>What was odd in this file, and what was assumed:</source>
        <translation>此文件的异常之处，以及所作的假设：</translation>
    </message>
</context>
<context>
    <name>Overview</name>
    <message>
        <source>Overview</source>
        <translation>总览</translation>
    </message>
    <message>
        <source>Overview of the whole recording</source>
        <translation>整段记录的总览</translation>
    </message>
    <message>
        <source>Drag the window or its ends; click to go there.</source>
        <translation>拖动窗口或其两端；点击可转到该处。</translation>
    </message>
    <message>
        <source>Frames {0} to {1}: {2} % of the samples are missing</source>
        <translation>第 {0} 至 {1} 帧：{2} % 的采样缺失</translation>
    </message>
</context>
<context>
    <name>Palette</name>
    <message>
        <source>Find an action</source>
        <translation>查找命令</translation>
    </message>
    <message>
        <source>Type what to do: an action, a pane, a recent file</source>
        <translation>输入要做什么：命令、窗格或最近的文件</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>要做什么</translation>
    </message>
    <message>
        <source>What fits</source>
        <translation>匹配项</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Nothing fits. Fewer letters find more.</source>
        <translation>没有匹配项。少输入几个字可找到更多。</translation>
    </message>
    <message>
        <source>Enter does it, Escape closes.</source>
        <translation>回车键执行，Esc 键关闭。</translation>
    </message>
    <message>
        <source>Open a recording first.</source>
        <translation>请先打开一个记录。</translation>
    </message>
    <message>
        <source>Only C3D recordings can be checked.</source>
        <translation>只能检查 C3D 记录。</translation>
    </message>
    <message>
        <source>Only one recording is open.</source>
        <translation>只打开了一个记录。</translation>
    </message>
    <message>
        <source>This recording has no markers.</source>
        <translation>此记录没有标记点。</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>没有可撤销的操作。</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>没有可重做的操作。</translation>
    </message>
    <message>
        <source>This is not possible now.</source>
        <translation>现在无法执行。</translation>
    </message>
    <message>
        <source>Pane</source>
        <translation>窗格</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>布局</translation>
    </message>
    <message>
        <source>Recent file</source>
        <translation>最近的文件</translation>
    </message>
    <message>
        <source>This file is gone: {0}</source>
        <translation>此文件已不存在：{0}</translation>
    </message>
</context>
<context>
    <name>ParamsForm</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>PlanModel</name>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation>预期误差</translation>
    </message>
    <message>
        <source>What would be done</source>
        <translation>将如何处理</translation>
    </message>
    <message>
        <source>{0} ({1} ms)</source>
        <translation>{0} ({1} ms)</translation>
    </message>
    <message>
        <source>… not computed yet</source>
        <translation>… 尚未计算</translation>
    </message>
    <message>
        <source>✔ filled</source>
        <translation>✔ 填补</translation>
    </message>
    <message>
        <source>○ stays open: {0}</source>
        <translation>○ 不填补：{0}</translation>
    </message>
</context>
<context>
    <name>PlanPane</name>
    <message>
        <source>Which gaps are listed</source>
        <translation>列出哪些缺失段</translation>
    </message>
    <message>
        <source>All gaps</source>
        <translation>全部缺失段</translation>
    </message>
    <message>
        <source>Would be filled</source>
        <translation>将填补的</translation>
    </message>
    <message>
        <source>Would stay open</source>
        <translation>不填补的</translation>
    </message>
    <message>
        <source>By {0}: {1} gaps ({2} samples) would be filled, {3} would stay open.</source>
        <translation>用“{0}”：将填补 {1} 个缺失段（{2} 个采样），{3} 个不填补。</translation>
    </message>
    <message>
        <source>{0} are not computed yet.</source>
        <translation>{0} 个尚未计算。</translation>
    </message>
    <message>
        <source>Fill plan</source>
        <translation>填补计划</translation>
    </message>
    <message>
        <source>Double-click a gap, or press Enter, to go there</source>
        <translation>双击缺失段或按回车键可转到该处</translation>
    </message>
    <message>
        <source>Compute</source>
        <translation>计算</translation>
    </message>
    <message>
        <source>Fill all</source>
        <translation>全部填补</translation>
    </message>
    <message>
        <source>Save plan…</source>
        <translation>保存计划…</translation>
    </message>
    <message>
        <source>Load plan…</source>
        <translation>载入计划…</translation>
    </message>
</context>
<context>
    <name>PlotCanvas</name>
    <message>
        <source>+{0} more</source>
        <translation>另有 {0} 个</translation>
    </message>
</context>
<context>
    <name>PlotPane</name>
    <message>
        <source>Bone</source>
        <translation>骨段</translation>
    </message>
    <message>
        <source>The two markers whose distance is plotted (B for the next)</source>
        <translation>绘制其间距的两个标记点（B 键换下一对）</translation>
    </message>
    <message>
        <source>no bone here</source>
        <translation>此处无骨段</translation>
    </message>
    <message>
        <source>XYZ</source>
        <translation>XYZ</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Accel.</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>1:1</source>
        <translation>1:1</translation>
    </message>
</context>
<context>
    <name>Previewer</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>the preview was cancelled</source>
        <translation>预览已取消</translation>
    </message>
    <message>
        <source>the preview failed</source>
        <translation>预览失败</translation>
    </message>
</context>
<context>
    <name>ProofActions</name>
    <message>
        <source>Save recipe</source>
        <translation>保存修复方案</translation>
    </message>
    <message>
        <source>Recipes (*.json)</source>
        <translation>修复方案 (*.json)</translation>
    </message>
    <message>
        <source>Writing the recipe</source>
        <translation>正在写入修复方案</translation>
    </message>
    <message>
        <source>Recipe written to {0}</source>
        <translation>修复方案已写入 {0}</translation>
    </message>
    <message>
        <source>Replay recipe</source>
        <translation>重放修复方案</translation>
    </message>
    <message>
        <source>Recipes (*.json);;All files (*)</source>
        <translation>修复方案 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Replaying {0}</source>
        <translation>正在重放 {0}</translation>
    </message>
    <message>
        <source>Save plan</source>
        <translation>保存计划</translation>
    </message>
    <message>
        <source>Plans (*.json)</source>
        <translation>计划 (*.json)</translation>
    </message>
    <message>
        <source>Plan written to {0}</source>
        <translation>计划已写入 {0}</translation>
    </message>
    <message>
        <source>Load plan</source>
        <translation>载入计划</translation>
    </message>
    <message>
        <source>Plans (*.json);;All files (*)</source>
        <translation>计划 (*.json);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Check a repaired copy</source>
        <translation>检查修复副本</translation>
    </message>
    <message>
        <source>C3D recordings (*.c3d *.C3D);;All files (*)</source>
        <translation>C3D 记录 (*.c3d *.C3D);;所有文件 (*)</translation>
    </message>
    <message>
        <source>Checking {0}</source>
        <translation>正在检查 {0}</translation>
    </message>
    <message>
        <source>The recording was edited meanwhile: replay again.</source>
        <translation>记录在此期间被编辑过：请重新重放。</translation>
    </message>
    <message>
        <source>The recipe has nothing to do here.</source>
        <translation>该修复方案在此处没有可做的操作。</translation>
    </message>
    <message>
        <source>replay {0}</source>
        <translation>重放 {0}</translation>
    </message>
    <message>
        <source>{0} edits made again.</source>
        <translation>已重做 {0} 项编辑。</translation>
    </message>
    <message>
        <source>{0} edits made again, by a recipe that was made for another file.</source>
        <translation>已重做 {0} 项编辑，所用的修复方案是为另一个文件制作的。</translation>
    </message>
</context>
<context>
    <name>QueueModel</name>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧数</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>误差</translation>
    </message>
    <message>
        <source>Harm</source>
        <translation>危害</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>Best</source>
        <translation>最佳</translation>
    </message>
    <message>
        <source>Context</source>
        <translation>周围</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>What has become of the gap</source>
        <translation>缺失段的处理状态</translation>
    </message>
    <message>
        <source>Missing frames</source>
        <translation>缺失的帧数</translation>
    </message>
    <message>
        <source>Expected error of the best repair that was tried, in mm</source>
        <translation>已尝试的最佳修复的预期误差 (mm)</translation>
    </message>
    <message>
        <source>Expected error times missing frames: what comes first is worst</source>
        <translation>预期误差乘以缺失帧数：排在最前的最严重</translation>
    </message>
    <message>
        <source>The method with the least expected error</source>
        <translation>预期误差最小的方法</translation>
    </message>
    <message>
        <source>Where the gap lies, and how many other markers are missing in its middle</source>
        <translation>缺失段的位置，以及其中点处还有多少其他标记点缺失</translation>
    </message>
    <message>
        <source>First and last missing frame</source>
        <translation>缺失的首帧和末帧</translation>
    </message>
    <message>
        <source>open</source>
        <translation>未填补</translation>
    </message>
    <message>
        <source>left open</source>
        <translation>保留未填</translation>
    </message>
    <message>
        <source>repaired</source>
        <translation>已修复</translation>
    </message>
    <message>
        <source>never to be filled</source>
        <translation>永不填补</translation>
    </message>
    <message>
        <source>start, {0} more missing</source>
        <translation>开头，另缺 {0} 个</translation>
    </message>
    <message>
        <source>end, {0} more missing</source>
        <translation>结尾，另缺 {0} 个</translation>
    </message>
    <message>
        <source>inside, {0} more missing</source>
        <translation>中间，另缺 {0} 个</translation>
    </message>
    <message>
        <source>{0}, frames {1} to {2}: {3}</source>
        <translation>{0}，第 {1} 至 {2} 帧：{3}</translation>
    </message>
    <message>
        <source>No repair that was tried could be tested here</source>
        <translation>已尝试的修复在此处都无法测试</translation>
    </message>
</context>
<context>
    <name>QueuePane</name>
    <message>
        <source>Filter markers</source>
        <translation>筛选标记点</translation>
    </message>
    <message>
        <source>Filter the queue by marker</source>
        <translation>按标记点筛选队列</translation>
    </message>
    <message>
        <source>Status</source>
        <translation>状态</translation>
    </message>
    <message>
        <source>Length of the gaps</source>
        <translation>缺失段的长度</translation>
    </message>
    <message>
        <source>Rank</source>
        <translation>排序</translation>
    </message>
    <message>
        <source>Try repairs on all gaps in the background, so that the worst come first</source>
        <translation>在后台对全部缺失段试行修复，使最严重的排在最前</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>未填补</translation>
    </message>
    <message>
        <source>Left open</source>
        <translation>保留未填</translation>
    </message>
    <message>
        <source>Repaired</source>
        <translation>已修复</translation>
    </message>
    <message>
        <source>Never to be filled</source>
        <translation>永不填补</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Any length</source>
        <translation>任意长度</translation>
    </message>
    <message>
        <source>Up to 0.2 s</source>
        <translation>0.2 s 以内</translation>
    </message>
    <message>
        <source>0.2 to 1 s</source>
        <translation>0.2 至 1 s</translation>
    </message>
    <message>
        <source>Above 1 s</source>
        <translation>1 s 以上</translation>
    </message>
    <message>
        <source>Queue of gaps</source>
        <translation>缺失段队列</translation>
    </message>
    <message>
        <source>inside, {0} more missing</source>
        <translation>中间，另缺 {0} 个</translation>
    </message>
    <message>
        <source>No gap passes the filter.</source>
        <translation>没有符合筛选条件的缺失段。</translation>
    </message>
    <message>
        <source>No marker is missing anywhere: there is nothing to fill.</source>
        <translation>没有标记点缺失：无需填补。</translation>
    </message>
    <message>
        <source>{0} gaps · ranked {1} of {2}</source>
        <translation>{0} 个缺失段 · 已排序 {1} / {2}</translation>
    </message>
    <message>
        <source>{0} gaps</source>
        <translation>{0} 个缺失段</translation>
    </message>
</context>
<context>
    <name>RecentFiles</name>
    <message>
        <source>Looking for recent files</source>
        <translation>正在查找最近的文件</translation>
    </message>
</context>
<context>
    <name>Recovery</name>
    <message>
        <source>Looking for edits to recover</source>
        <translation>正在查找可恢复的编辑</translation>
    </message>
    <message>
        <source>Recovered 1 edit of {1}</source>
        <translation>已恢复 {1} 的 1 项编辑</translation>
    </message>
    <message>
        <source>Recovered {0} edits of {1}</source>
        <translation>已恢复 {1} 的 {0} 项编辑</translation>
    </message>
</context>
<context>
    <name>RecoveryDialog</name>
    <message>
        <source>Recover edits</source>
        <translation>恢复编辑</translation>
    </message>
    <message>
        <source>The program ended before these edits were exported. Recover opens the recording with the edits, which can still be undone; the file itself is not changed.</source>
        <translation>程序在导出这些编辑之前就结束了。“恢复”会打开记录并带上这些编辑，编辑仍可撤销；文件本身不会改变。</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>恢复</translation>
    </message>
    <message>
        <source>Recover all</source>
        <translation>全部恢复</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>丢弃</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>以后再说</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Edits</source>
        <translation>编辑数</translation>
    </message>
    <message>
        <source>Last edit</source>
        <translation>最后编辑</translation>
    </message>
    <message>
        <source>Recordings with edits that can be recovered</source>
        <translation>有可恢复编辑的记录</translation>
    </message>
</context>
<context>
    <name>RepairModel</name>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Expected error</source>
        <translation>预期误差</translation>
    </message>
    <message>
        <source>Made</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>Donors</source>
        <translation>参考标记点</translation>
    </message>
    <message>
        <source>before</source>
        <translation>此前</translation>
    </message>
    <message>
        <source>now</source>
        <translation>现在</translation>
    </message>
    <message>
        <source>{0}: click to go there, Del turns the repair back into a gap</source>
        <translation>{0}：点击可转到该处，Del 键将修复还原为缺失段</translation>
    </message>
    <message>
        <source>Computed from {0}</source>
        <translation>由 {0} 计算得出</translation>
    </message>
</context>
<context>
    <name>RepairPanel</name>
    <message>
        <source>Current gap</source>
        <translation>当前缺失段</translation>
    </message>
    <message>
        <source>◀ Previous</source>
        <translation>◀ 上一个</translation>
    </message>
    <message>
        <source>Next ▶</source>
        <translation>下一个 ▶</translation>
    </message>
    <message>
        <source>Root mean square of the 3-D error, and the radius that holds 90 % of the errors, on stretches of this recording that were hidden for the test.</source>
        <translation>三维误差的均方根，以及包含 90 % 误差的半径；在此记录中为测试而隐藏的片段上测得。</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Reopen the gap</source>
        <translation>还原缺失段</translation>
    </message>
    <message>
        <source>All gaps, with this method</source>
        <translation>用此方法处理全部缺失段</translation>
    </message>
    <message>
        <source>Show what stayed open…</source>
        <translation>显示未填补的…</translation>
    </message>
    <message>
        <source>Fill all</source>
        <translation>全部填补</translation>
    </message>
    <message>
        <source>Plan…</source>
        <translation>计划…</translation>
    </message>
    <message>
        <source>No marker is missing anywhere: there is nothing to fill.</source>
        <translation>没有标记点缺失：无需填补。</translation>
    </message>
    <message>
        <source>Press N for the next gap, or click one on the timeline.</source>
        <translation>按 N 转到下一个缺失段，或在时间线上点击一个。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Never to be filled.&lt;/b&gt; Shift+X makes it a gap again.</source>
        <translation>&lt;b&gt;永不填补。&lt;/b&gt;按 Shift+X 可恢复为缺失段。</translation>
    </message>
    <message>
        <source>Repaired with &lt;b&gt;{0}&lt;/b&gt;</source>
        <translation>已用&lt;b&gt;{0}&lt;/b&gt;修复</translation>
    </message>
    <message>
        <source>Computing the preview…</source>
        <translation>正在计算预览…</translation>
    </message>
    <message>
        <source>{0} open gaps</source>
        <translation>{0} 个未填补的缺失段</translation>
    </message>
    <message>
        <source>, at the start</source>
        <translation>，在开头</translation>
    </message>
    <message>
        <source>, at the end</source>
        <translation>，在结尾</translation>
    </message>
    <message>
        <source>, never seen</source>
        <translation>，从未出现</translation>
    </message>
    <message>
        <source>frame {0}
1 frame</source>
        <translation>第 {0} 帧
1 帧</translation>
    </message>
    <message>
        <source>frames {0} to {1}
{2} frames</source>
        <translation>第 {0} 至 {1} 帧
{2} 帧</translation>
    </message>
    <message>
        <source>{0}: {1} ({2} ms){3}</source>
        <translation>{0}：{1} ({2} ms){3}</translation>
    </message>
    <message>
        <source>{0} + {1} measured frames at its ends cut off</source>
        <translation>两端切除了 {0} + {1} 个测量帧</translation>
    </message>
    <message>
        <source>&lt;b&gt;Stays open:&lt;/b&gt; {0}</source>
        <translation>&lt;b&gt;不填补：&lt;/b&gt;{0}</translation>
    </message>
    <message>
        <source>&lt;b&gt;⚠ Above the limit of {0} mm&lt;/b&gt;</source>
        <translation>&lt;b&gt;⚠ 超过限值 {0} mm&lt;/b&gt;</translation>
    </message>
    <message>
        <source>A cubic spline: the other markers say less about this gap.</source>
        <translation>三次样条：其他标记点对此缺失段的提示更少。</translation>
    </message>
    <message>
        <source>all markers</source>
        <translation>全部标记点</translation>
    </message>
    <message>
        <source>this marker</source>
        <translation>此标记点</translation>
    </message>
    <message>
        <source>Measured on {0} hidden stretches of {1}.</source>
        <translation>在{1}的 {0} 个隐藏片段上测得。</translation>
    </message>
    <message>
        <source>Expected error &lt;b&gt;unknown&lt;/b&gt;: too little of the recording to test on</source>
        <translation>预期误差&lt;b&gt;未知&lt;/b&gt;：记录太短，无法测试</translation>
    </message>
    <message>
        <source>Expected error &lt;b&gt;{0} mm&lt;/b&gt;</source>
        <translation>预期误差 &lt;b&gt;{0} mm&lt;/b&gt;</translation>
    </message>
    <message>
        <source>, 90 % within {0} mm</source>
        <translation>，90 % 在 {0} mm 以内</translation>
    </message>
    <message>
        <source>Donors: {0}</source>
        <translation>参考标记点：{0}</translation>
    </message>
</context>
<context>
    <name>RepairTable</name>
    <message>
        <source>Nothing is repaired yet. Repairs are listed here.</source>
        <translation>尚无修复。修复会列在这里。</translation>
    </message>
    <message>
        <source>Repairs</source>
        <translation>修复列表</translation>
    </message>
    <message>
        <source>before</source>
        <translation>此前</translation>
    </message>
</context>
<context>
    <name>ReportPane</name>
    <message>
        <source>Tracking</source>
        <translation>跟踪</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>骨段</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Methods</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>Check a copy…</source>
        <translation>检查副本…</translation>
    </message>
    <message>
        <source>Pages of the report</source>
        <translation>报告页</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
</context>
<context>
    <name>Samples</name>
    <message>
        <source>Wheelchair sprint, many gaps</source>
        <translation>轮椅冲刺，缺失段很多</translation>
    </message>
    <message>
        <source>Gait, Plug-in Gait, with fragments</source>
        <translation>步态，Plug-in Gait，有零碎片段</translation>
    </message>
    <message>
        <source>Walk, 41 markers, complete</source>
        <translation>行走，41 个标记点，完整</translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>segment {0}</source>
        <translation>节段 {0}</translation>
    </message>
    <message>
        <source>Before and after: no edits in this frame</source>
        <translation>编辑前后：此帧没有编辑</translation>
    </message>
    <message>
        <source>Before and after: {0} filled, {1} moved, {2} removed</source>
        <translation>编辑前后：填补 {0}，移动 {1}，删除 {2}</translation>
    </message>
    <message>
        <source>Measure: select two markers for a distance, three for an angle</source>
        <translation>测量：选两个标记点量距离，选三个量角度</translation>
    </message>
    <message>
        <source>{0}: missing here ({1})</source>
        <translation>{0}：此处缺失 ({1})</translation>
    </message>
    <message>
        <source>{0}: no angle, two of them are at one place</source>
        <translation>{0}：没有角度，其中两个在同一位置</translation>
    </message>
    <message>
        <source>{0}: {1} (not measured: {2})</source>
        <translation>{0}：{1}（非测量值：{2}）</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}：{1}</translation>
    </message>
</context>
<context>
    <name>ScenePicture</name>
    <message>
        <source>3D marker view</source>
        <translation>标记点三维视图</translation>
    </message>
    <message>
        <source>Segments: none are known for this recording</source>
        <translation>节段：此记录没有已知的节段</translation>
    </message>
</context>
<context>
    <name>ShortcutsDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>键盘快捷键</translation>
    </message>
    <message>
        <source>Search for an action or a key</source>
        <translation>搜索命令或按键</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>搜索</translation>
    </message>
    <message>
        <source>New key</source>
        <translation>新按键</translation>
    </message>
    <message>
        <source>Set</source>
        <translation>设定</translation>
    </message>
    <message>
        <source>Make this the only key of the action</source>
        <translation>使其成为该命令的唯一按键</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>添加</translation>
    </message>
    <message>
        <source>Keep its other keys too</source>
        <translation>同时保留其他按键</translation>
    </message>
    <message>
        <source>No key</source>
        <translation>无按键</translation>
    </message>
    <message>
        <source>Reset</source>
        <translation>重置</translation>
    </message>
    <message>
        <source>Give the action its first keys again</source>
        <translation>恢复该命令最初的按键</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>全部重置</translation>
    </message>
    <message>
        <source>Menu</source>
        <translation>菜单</translation>
    </message>
    <message>
        <source>Action</source>
        <translation>命令</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>按键</translation>
    </message>
    <message>
        <source>Actions and their keys</source>
        <translation>命令及其按键</translation>
    </message>
    <message>
        <source>3D view: drag to orbit, Shift+drag to move, wheel to zoom, click to pick, double-click to centre. Plots and timeline: drag to scrub, wheel to zoom, Shift+wheel to move, double-click a gap to go there; Ctrl+click adds a marker.</source>
        <translation>三维视图：拖动旋转，Shift+拖动平移，滚轮缩放，点击选取，双击居中。曲线和时间线：拖动浏览，滚轮缩放，Shift+滚轮平移，双击缺失段可转到该处；Ctrl+点击可添加标记点。</translation>
    </message>
    <message>
        <source>{0} (changed)</source>
        <translation>{0}（已更改）</translation>
    </message>
    <message>
        <source>{0} belongs to “{1}”. Choose another key, or change that one first.</source>
        <translation>{0} 已属于“{1}”。请选择其他按键，或先更改那个命令。</translation>
    </message>
    <message>
        <source>One of its first keys belongs to “{0}” now. Change that one first.</source>
        <translation>其最初的按键之一现在属于“{0}”。请先更改那个命令。</translation>
    </message>
</context>
<context>
    <name>Survey</name>
    <message>
        <source>Ranking</source>
        <translation>正在排序</translation>
    </message>
</context>
<context>
    <name>TimeActions</name>
    <message>
        <source>This recording has no events.</source>
        <translation>此记录没有事件。</translation>
    </message>
    <message>
        <source>No frames are selected: drag with Shift, or press I and O.</source>
        <translation>没有选择帧：请按住 Shift 拖动，或按 I 和 O。</translation>
    </message>
    <message>
        <source>No gap is chosen: press N for the next one.</source>
        <translation>没有选择缺失段：按 N 转到下一个。</translation>
    </message>
</context>
<context>
    <name>Timeline</name>
    <message>
        <source>Timeline</source>
        <translation>时间线</translation>
    </message>
</context>
<context>
    <name>TimelineMarks</name>
    <message>
        <source>{0} s</source>
        <translation>{0} s</translation>
    </message>
    <message>
        <source>{0} frames, {1} s</source>
        <translation>{0} 帧，{1} s</translation>
    </message>
</context>
<context>
    <name>TimelineTexts</name>
    <message>
        <source>{0}: measured here</source>
        <translation>{0}：此处为测量值</translation>
    </message>
    <message>
        <source>{0}: repaired, frames {1} to {2}</source>
        <translation>{0}：已修复，第 {1} 至 {2} 帧</translation>
    </message>
    <message>
        <source>{0}: missing from frame {1} to {2}, {3} frames ({4} ms)</source>
        <translation>{0}：第 {1} 至 {2} 帧缺失，共 {3} 帧 ({4} ms)</translation>
    </message>
    <message>
        <source>{0}, frame {1}, {2} s</source>
        <translation>{0}，第 {1} 帧，{2} s</translation>
    </message>
    <message>
        <source>Frame {0}, {1} s: {2} of {3} markers are missing.</source>
        <translation>第 {0} 帧，{1} s：{3} 个标记点中缺失 {2} 个。</translation>
    </message>
    <message>
        <source>Current gap: {0}.</source>
        <translation>当前缺失段：{0}。</translation>
    </message>
    <message>
        <source>Selected: frames {0} to {1}.</source>
        <translation>已选择：第 {0} 至 {1} 帧。</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Step {0} of {1}</source>
        <translation>第 {0} 步，共 {1} 步</translation>
    </message>
    <message>
        <source>Open a sample</source>
        <translation>打开示例</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
    <message>
        <source>Welcome. Open a recording: drop a file here, or begin with a sample.</source>
        <translation>欢迎。请打开一个记录：把文件拖到这里，或从示例开始。</translation>
    </message>
    <message>
        <source>Each lane is a marker, orange is where it is missing. Press {0} to go to the next gap, or double-click one.</source>
        <translation>每条轨道是一个标记点，橙色处为缺失。按 {0} 转到下一个缺失段，或双击任一缺失段。</translation>
    </message>
    <message>
        <source>The yellow curve is the proposed repair with its 90 % band. Nothing is changed yet. {0} shows another method.</source>
        <translation>黄色曲线是建议的修复及其 90 % 置信带。此时还没有任何改动。按 {0} 可查看另一种方法。</translation>
    </message>
    <message>
        <source>Here is how far off the repair is expected to be. {0} applies it, {1} takes it back, and {2} repairs all gaps up to the limit.</source>
        <translation>这里显示修复的预期误差。按 {0} 应用，按 {1} 撤销，按 {2} 修复限值内的全部缺失段。</translation>
    </message>
    <message>
        <source>The Report tab compares before and after ({0}), the History tab goes back to any step ({1}).</source>
        <translation>“报告”标签页比较修复前后 ({0})，“历史”标签页可回到任一步骤 ({1})。</translation>
    </message>
    <message>
        <source>{0} writes a repaired copy in which nothing else changes, and proves it. {1} finds everything that the program can do.</source>
        <translation>按 {0} 写出修复后的副本，其余内容不变，并加以验证。按 {1} 可找到程序的全部功能。</translation>
    </message>
</context>
<context>
    <name>TrackingPage</name>
    <message>
        <source>Tracked now</source>
        <translation>当前跟踪率</translation>
    </message>
    <message>
        <source>Mean so far</source>
        <translation>累计平均</translation>
    </message>
    <message>
        <source>Never lost</source>
        <translation>从未丢失</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Segments</source>
        <translation>节段</translation>
    </message>
    <message>
        <source>What the curves count</source>
        <translation>曲线统计的对象</translation>
    </message>
    <message>
        <source>A segment is a group of markers that keep their distances to each other</source>
        <translation>节段是一组彼此距离保持不变的标记点</translation>
    </message>
    <message>
        <source>{0}: {1} % before, {2} % after</source>
        <translation>{0}：修复前 {1} %，修复后 {2} %</translation>
    </message>
    <message>
        <source>before (dashed)</source>
        <translation>修复前（虚线）</translation>
    </message>
    <message>
        <source>after (solid)</source>
        <translation>修复后（实线）</translation>
    </message>
</context>
<context>
    <name>TrainingBox</name>
    <message>
        <source>this recording</source>
        <translation>此记录</translation>
    </message>
    <message>
        <source>Browse…</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>Browse for a training set</source>
        <translation>浏览训练集</translation>
    </message>
    <message>
        <source>Choose a training set</source>
        <translation>选择训练集</translation>
    </message>
    <message>
        <source>Training sets (*.npz)</source>
        <translation>训练集 (*.npz)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>Trajectories</name>
    <message>
        <source>Speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>Accel.</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Trajectory plots</source>
        <translation>轨迹曲线</translation>
    </message>
    <message>
        <source>Select a marker to see its trajectory</source>
        <translation>选择标记点可查看其轨迹</translation>
    </message>
    <message>
        <source>Nothing is chosen to be plotted: press V</source>
        <translation>没有选择要绘制的内容：请按 V</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>Frame {0} · {1} s</source>
        <translation>第 {0} 帧 · {1} s</translation>
    </message>
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Playback speed</source>
        <translation>播放速度</translation>
    </message>
    <message>
        <source>Playback speed ([ and ])</source>
        <translation>播放速度（[ 和 ]）</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>  Frame</source>
        <translation>  帧</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Open recordings (C3D, TRC, CSV, BVH, ASF/AMC, npz), or drop them here.</source>
        <translation>打开记录（C3D、TRC、CSV、BVH、ASF/AMC、npz），或将文件拖到这里。</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>打开…</translation>
    </message>
    <message>
        <source>Sample recordings</source>
        <translation>示例记录</translation>
    </message>
    <message>
        <source>Recent files</source>
        <translation>最近的文件</translation>
    </message>
    <message>
        <source>{0} is gone</source>
        <translation>{0} 已不存在</translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation>从列表中移除</translation>
    </message>
    <message>
        <source>Remove {0} from the list</source>
        <translation>从列表中移除 {0}</translation>
    </message>
</context>
<context>
    <name>Workspace</name>
    <message>
        <source>Skeleton</source>
        <translation>骨架</translation>
    </message>
    <message>
        <source>This file has no analog channels.</source>
        <translation>此文件没有模拟通道。</translation>
    </message>
    <message>
        <source>Trails reach {0} s back and ahead.</source>
        <translation>尾迹前后各 {0} s。</translation>
    </message>
    <message>
        <source>This method takes no donors.</source>
        <translation>此方法不使用参考标记点。</translation>
    </message>
    <message>
        <source>{0} gaps filled, {1} left open.</source>
        <translation>已填补 {0} 个缺失段，{1} 个未填补。</translation>
    </message>
    <message>
        <source>Not exported yet.</source>
        <translation>尚未导出。</translation>
    </message>
    <message>
        <source>Edited since {0} was exported.</source>
        <translation>导出 {0} 之后又有编辑。</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>模拟通道</translation>
    </message>
    <message>
        <source>Markers</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Queue</source>
        <translation>队列</translation>
    </message>
    <message>
        <source>Repair</source>
        <translation>修复</translation>
    </message>
    <message>
        <source>Timeline</source>
        <translation>时间线</translation>
    </message>
    <message>
        <source>Repairs</source>
        <translation>修复列表</translation>
    </message>
    <message>
        <source>Plan</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>报告</translation>
    </message>
    <message>
        <source>History</source>
        <translation>历史</translation>
    </message>
    <message>
        <source>{0} events</source>
        <translation>{0} 个事件</translation>
    </message>
    <message>
        <source>{0} analog channels</source>
        <translation>{0} 个模拟通道</translation>
    </message>
    <message>
        <source>{0} model outputs</source>
        <translation>{0} 个模型输出</translation>
    </message>
    <message>
        <source>This file has no marker samples: there is nothing to repair.

It holds {0}.</source>
        <translation>此文件没有标记点采样：没有可修复的内容。

其中有 {0}。</translation>
    </message>
    <message>
        <source>nothing that can be shown</source>
        <translation>没有可显示的内容</translation>
    </message>
</context>
</TS>
