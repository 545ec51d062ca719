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
        <source>Select the markers in view</source>
        <translation>选择视图内的标记点</translation>
    </message>
    <message>
        <source>Add the markers in view</source>
        <translation>加选视图内的标记点</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>重命名…</translation>
    </message>
    <message>
        <source>Exchange the names of the two selected markers</source>
        <translation>交换所选两个标记点的名称</translation>
    </message>
    <message>
        <source>This is…</source>
        <translation>这是…</translation>
    </message>
    <message>
        <source>Next point without a label</source>
        <translation>下一个没有标签的点</translation>
    </message>
    <message>
        <source>Label from recordings…</source>
        <translation>按已标注的记录标注…</translation>
    </message>
    <message>
        <source>Apply the proposed labels</source>
        <translation>应用建议的标签</translation>
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
        <source>Say why this gap stays open…</source>
        <translation>说明此缺失段为何不填补…</translation>
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
        <source>Look for bad samples</source>
        <translation>查找坏采样</translation>
    </message>
    <message>
        <source>Fix this problem</source>
        <translation>修正此问题</translation>
    </message>
    <message>
        <source>Fix all problems of this kind</source>
        <translation>修正所有此类问题</translation>
    </message>
    <message>
        <source>Fix all problems</source>
        <translation>修正所有问题</translation>
    </message>
    <message>
        <source>This is no problem</source>
        <translation>这不是问题</translation>
    </message>
    <message>
        <source>Set the selected samples aside</source>
        <translation>搁置所选采样</translation>
    </message>
    <message>
        <source>Believe samples that were set aside</source>
        <translation>重新采用被搁置的采样</translation>
    </message>
    <message>
        <source>Next gap or problem</source>
        <translation>下一个缺失段或问题</translation>
    </message>
    <message>
        <source>Previous gap or problem</source>
        <translation>上一个缺失段或问题</translation>
    </message>
    <message>
        <source>Exchange the samples of the two selected markers</source>
        <translation>交换所选两个标记点的采样</translation>
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
        <source>Refine by a network…</source>
        <translation>用网络精修…</translation>
    </message>
    <message>
        <source>Smooth the chosen markers</source>
        <translation>平滑所选范围的标记点</translation>
    </message>
    <message>
        <source>Take smoothing off the chosen markers</source>
        <translation>取消所选范围标记点的平滑</translation>
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
        <source>Compare with recording…</source>
        <translation>与另一记录比较…</translation>
    </message>
    <message>
        <source>Show the compared recording</source>
        <translation>显示用于比较的记录</translation>
    </message>
    <message>
        <source>Stop comparing</source>
        <translation>停止比较</translation>
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
        <source>Zoom to the gap or problem</source>
        <translation>缩放到缺失段或问题</translation>
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
        <source>Go to smoothing</source>
        <translation>转到平滑</translation>
    </message>
    <message>
        <source>Go to the history</source>
        <translation>转到历史</translation>
    </message>
    <message>
        <source>Go to the labels</source>
        <translation>转到标签</translation>
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
    <name>BadActions</name>
    <message>
        <source>This problem is fixed already; undo takes it back.</source>
        <translation>此问题已修正；可用撤销取回。</translation>
    </message>
    <message>
        <source>This piece fits no marker: exchange it by hand, or say it is no problem.</source>
        <translation>此片段不属于任何标记点：请手动互换，或标为没有问题。</translation>
    </message>
    <message>
        <source>Unsure labels are accepted one by one.</source>
        <translation>不确定的标签要逐个接受。</translation>
    </message>
    <message>
        <source>No problem: it is listed under that status from now on.</source>
        <translation>没有问题：从现在起列在该状态下。</translation>
    </message>
    <message>
        <source>It is a problem again.</source>
        <translation>它又是问题了。</translation>
    </message>
    <message>
        <source>The bones are still being looked for: try again soon.</source>
        <translation>仍在查找骨段：请稍后再试。</translation>
    </message>
    <message>
        <source>Looking for bad samples</source>
        <translation>查找坏采样</translation>
    </message>
    <message>
        <source>The recording was corrected meanwhile: try again.</source>
        <translation>记录在此期间被修正过：请再试一次。</translation>
    </message>
    <message>
        <source>No measured sample is selected here.</source>
        <translation>此处没有选中测得的采样。</translation>
    </message>
    <message>
        <source>Samples set aside: {0}.</source>
        <translation>已搁置的采样：{0}。</translation>
    </message>
    <message>
        <source>No sample is set aside here.</source>
        <translation>此处没有被搁置的采样。</translation>
    </message>
    <message>
        <source>Samples believed again: {0}.</source>
        <translation>重新采用的采样：{0}。</translation>
    </message>
    <message>
        <source>Select the two markers to be exchanged (Ctrl+click adds one).</source>
        <translation>请选择要互换的两个标记点（Ctrl+单击可添加）。</translation>
    </message>
    <message>
        <source>Neither of the two markers is seen here.</source>
        <translation>此处两个标记点都不可见。</translation>
    </message>
    <message>
        <source>Dashed lines show how it would be: Ctrl+E again exchanges the two.</source>
        <translation>虚线表示互换后的样子：再按一次 Ctrl+E 即互换二者。</translation>
    </message>
    <message>
        <source>Exchanged in {0} frames, from frame {1} on.</source>
        <translation>已互换 {0} 帧，从第 {1} 帧起。</translation>
    </message>
    <message>
        <source>All unsure labels are looked at: apply them in the pane of labels.</source>
        <translation>不确定的标签已全部查看：请在标签窗格中应用。</translation>
    </message>
    <message>
        <source>Bad samples are not known yet: look for them first (Ctrl+F).</source>
        <translation>尚不知道坏采样：请先查找 (Ctrl+F)。</translation>
    </message>
    <message>
        <source>There is nothing that could be fixed.</source>
        <translation>没有可以修正的问题。</translation>
    </message>
    <message>
        <source>Problems fixed: {0}. Samples set aside are gaps now, to be filled.</source>
        <translation>已修正的问题：{0}。被搁置的采样现在是缺失段，有待填补。</translation>
    </message>
    <message>
        <source>Problems fixed: {0}.</source>
        <translation>已修正的问题：{0}。</translation>
    </message>
    <message>
        <source>There is no bad sample here: choose a problem first (N).</source>
        <translation>此处没有坏采样：请先选择一个问题 (N)。</translation>
    </message>
    <message>
        <source>Bad samples found: {0}; they are in the queue.</source>
        <translation>找到的坏采样：{0} 处；已列入队列。</translation>
    </message>
    <message>
        <source>No bad samples were found.</source>
        <translation>没有找到坏采样。</translation>
    </message>
</context>
<context>
    <name>BadSearch</name>
    <message>
        <source>Looking for bad samples</source>
        <translation>查找坏采样</translation>
    </message>
</context>
<context>
    <name>BoneSearch</name>
    <message>
        <source>Skeleton</source>
        <translation>骨架</translation>
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
    <name>CompanionActions</name>
    <message>
        <source>Compare with a recording</source>
        <translation>与另一记录比较</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
    <message>
        <source>Reading {0} to compare</source>
        <translation>正在读取 {0} 以作比较</translation>
    </message>
    <message>
        <source>No recording is compared with this one.</source>
        <translation>没有与此记录比较的记录。</translation>
    </message>
    <message>
        <source>No longer compared with {0}.</source>
        <translation>不再与 {0} 比较。</translation>
    </message>
    <message>
        <source>Compared with {0}, from which this recording was made.</source>
        <translation>与 {0} 比较，此记录由它得出。</translation>
    </message>
    <message>
        <source>Compared with {0}, turned and shifted so that common labels fit.</source>
        <translation>与 {0} 比较，已旋转和平移，使共同的标签相合。</translation>
    </message>
    <message>
        <source>Compared with {0} in its own place: fewer than three labels are common, or too little of the time is.</source>
        <translation>与 {0} 在其原位置比较：共同的标签不足三个，或共同的时间太短。</translation>
    </message>
</context>
<context>
    <name>Detectors</name>
    <message>
        <source>Spikes</source>
        <translation>尖峰</translation>
    </message>
    <message>
        <source>Swapped labels</source>
        <translation>标签互换</translation>
    </message>
    <message>
        <source>Fragments and ghosts</source>
        <translation>片段与鬼点</translation>
    </message>
    <message>
        <source>Ragged ends</source>
        <translation>残缺端</translation>
    </message>
    <message>
        <source>Frozen samples</source>
        <translation>冻结采样</translation>
    </message>
    <message>
        <source>Broken bones</source>
        <translation>骨长异常</translation>
    </message>
    <message>
        <source>Far from the body</source>
        <translation>远离身体</translation>
    </message>
    <message>
        <source>Coinciding points</source>
        <translation>重合点</translation>
    </message>
    <message>
        <source>Samples that leave the trajectory for one or a few frames and come back. Fast motion is told apart by the frames on both sides and by the neighbouring markers.</source>
        <translation>偏离轨迹一帧或几帧后又回来的采样。根据两侧的帧和相邻标记点与快速运动区分。</translation>
    </message>
    <message>
        <source>Two markers that carry each other&apos;s label for some time, also where a gap or the end of the recording hides where it begins or ends. Labels that are swapped throughout cannot be found.</source>
        <translation>两个标记点在一段时间内互换了标签，也包括起止被缺失段或记录端点遮住的情形。始终互换的标签无法找到。</translation>
    </message>
    <message>
        <source>Points without a label, and labels that come twice, that are pieces of a marker&apos;s trajectory. Those that fit no marker are listed as ghosts.</source>
        <translation>没有名称的点和重复的名称，其实是某标记点轨迹的片段。不属于任何标记点的列为鬼点。</translation>
    </message>
    <message>
        <source>Samples just before or after a gap that bend away from the trajectory, as those of a marker that is half hidden.</source>
        <translation>紧接缺失段前后、偏离轨迹的采样，如半遮挡的标记点。</translation>
    </message>
    <message>
        <source>Samples that repeat the one before exactly while the marker goes on moving. Files in which repeats are usual, as up-sampled ones, are left alone.</source>
        <translation>标记点仍在运动而采样与前一个完全相同。常有重复的文件（如上采样的）不予处理。</translation>
    </message>
    <message>
        <source>Markers that for some frames are at another distance from their neighbours than otherwise, and go there or come back in a jump.</source>
        <translation>在若干帧内与相邻标记点的距离异常、并且突然跳去或跳回的标记点。</translation>
    </message>
    <message>
        <source>Points much further from the body than its markers are, and than they usually are.</source>
        <translation>比身体上的标记点以及其自身平时远得多的点。</translation>
    </message>
    <message>
        <source>Two points in the same place that are apart otherwise: one is a reflection, or was labelled twice.</source>
        <translation>平时分开而处于同一位置的两个点：其一是反光，或被标注了两次。</translation>
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
        <source>Filling {0} gaps again</source>
        <translation>重新填补 {0} 个缺失段</translation>
    </message>
    <message>
        <source>Gaps filled again: {0}.</source>
        <translation>重新填补的缺失段：{0}。</translation>
    </message>
    <message>
        <source>Cancelled: {0} fills are from before the correction.</source>
        <translation>已取消：{0} 处填补早于修正。</translation>
    </message>
    <message>
        <source>Fill all gaps</source>
        <translation>填补全部缺失段</translation>
    </message>
    <message>
        <source>Cancelled: nothing was filled.</source>
        <translation>已取消：没有填补任何缺失段。</translation>
    </message>
    <message>
        <source>Gaps: {0} filled, {1} left open.</source>
        <translation>缺失段：已填补 {0} 个，未填补 {1} 个。</translation>
    </message>
</context>
<context>
    <name>FixFirst</name>
    <message>
        <source>Fix bad samples first</source>
        <translation>先修正坏采样</translation>
    </message>
    <message>
        <source>Before all gaps are filled, set aside or exchange: {0}</source>
        <translation>在填补所有缺失段之前，搁置或互换：{0}</translation>
    </message>
</context>
<context>
    <name>GapActions</name>
    <message>
        <source>No problem is left in the queue.</source>
        <translation>队列中没有问题了。</translation>
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
        <source>There is no repair here.</source>
        <translation>此处没有修复。</translation>
    </message>
    <message>
        <source>The gap is open again.</source>
        <translation>该缺失段已恢复为未填补。</translation>
    </message>
    <message>
        <source>There is no gap here.</source>
        <translation>此处没有缺失段。</translation>
    </message>
    <message>
        <source>The ends of this gap go no further.</source>
        <translation>此缺失段的两端不能再移动。</translation>
    </message>
    <message>
        <source>There is no open gap here.</source>
        <translation>此处没有未填补的缺失段。</translation>
    </message>
</context>
<context>
    <name>HandLabelActions</name>
    <message>
        <source>Select a marker first.</source>
        <translation>请先选择一个标记点。</translation>
    </message>
    <message>
        <source>{0} is called {1} now.</source>
        <translation>{0} 现在叫 {1}。</translation>
    </message>
    <message>
        <source>Frames {0} to {1} of {2} are {3} now.</source>
        <translation>{2} 的第 {0} 至 {1} 帧现在是 {3}。</translation>
    </message>
    <message>
        <source>All points that are seen have labels.</source>
        <translation>所有可见的点都有标签。</translation>
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
    <name>LabelChooser</name>
    <message>
        <source>free here</source>
        <translation>此处空闲</translation>
    </message>
    <message>
        <source>no point has it yet</source>
        <translation>还没有点用它</translation>
    </message>
    <message>
        <source>is seen here: the two are exchanged</source>
        <translation>此处可见：两者互换</translation>
    </message>
    <message>
        <source>{0} is…</source>
        <translation>{0} 是…</translation>
    </message>
    <message>
        <source>Type a label</source>
        <translation>输入标签</translation>
    </message>
    <message>
        <source>Which marker it is</source>
        <translation>它是哪个标记点</translation>
    </message>
    <message>
        <source>new label</source>
        <translation>新标签</translation>
    </message>
    <message>
        <source>No point has this label. Rename the marker instead (F2).</source>
        <translation>没有点使用此标签。请改为重命名该标记点 (F2)。</translation>
    </message>
</context>
<context>
    <name>LabelDialog</name>
    <message>
        <source>Label from recordings</source>
        <translation>按已标注的记录标注</translation>
    </message>
    <message>
        <source>Choose labelled recordings of the same marker set, best of the same subject. Nothing is changed before you have looked at the proposals.</source>
        <translation>选择使用同一标记点方案的已标注记录，最好是同一受试者。在您查看建议之前，不会更改任何内容。</translation>
    </message>
    <message>
        <source>Labelled recordings</source>
        <translation>已标注的记录</translation>
    </message>
    <message>
        <source>Keep the names that this recording has</source>
        <translation>保留此记录已有的名称</translation>
    </message>
    <message>
        <source>Off: label all points anew, also those that have names of the marker set</source>
        <translation>关闭：重新标注所有点，包括已有方案中名称的点</translation>
    </message>
    <message>
        <source>Add…</source>
        <translation>添加…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>移除</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>标注</translation>
    </message>
    <message>
        <source>Templates of labels (*.json)</source>
        <translation>标签模板 (*.json)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
    </message>
</context>
<context>
    <name>LabelModel</name>
    <message>
        <source>Now</source>
        <translation>当前</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>帧</translation>
    </message>
    <message>
        <source>Proposed</source>
        <translation>建议</translation>
    </message>
    <message>
        <source>Sure</source>
        <translation>把握</translation>
    </message>
    <message>
        <source>Reason</source>
        <translation>理由</translation>
    </message>
    <message>
        <source>no marker</source>
        <translation>不是标记点</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>sure enough</source>
        <translation>把握足够</translation>
    </message>
    <message>
        <source>too unsure to be used</source>
        <translation>把握不足，不采用</translation>
    </message>
</context>
<context>
    <name>LabelPane</name>
    <message>
        <source>There is nothing to be labelled.</source>
        <translation>没有可标注的内容。</translation>
    </message>
    <message>
        <source>Pieces labelled: {0}.</source>
        <translation>已标注的片段：{0}。</translation>
    </message>
    <message>
        <source>Pieces labelled: {0}. Samples set aside, for want of a point: {1}.</source>
        <translation>已标注的片段：{0}。因没有空闲的点而搁置的采样：{1}。</translation>
    </message>
    <message>
        <source>Label of this piece</source>
        <translation>此片段的标签</translation>
    </message>
    <message>
        <source>Another label for this piece; those that are free at that time come first</source>
        <translation>为此片段另选标签；当时空闲的排在前面</translation>
    </message>
    <message>
        <source>Accept (Enter)</source>
        <translation>接受 (Enter)</translation>
    </message>
    <message>
        <source>Reject (Del)</source>
        <translation>拒绝 (Del)</translation>
    </message>
    <message>
        <source>Least confidence</source>
        <translation>最低把握</translation>
    </message>
    <message>
        <source>Labels that are less sure are not given, unless you accept them</source>
        <translation>把握更低的标签不会赋予，除非您接受</translation>
    </message>
    <message>
        <source>Apply</source>
        <translation>应用</translation>
    </message>
    <message>
        <source>Run again</source>
        <translation>重新运行</translation>
    </message>
    <message>
        <source>Label from recordings…</source>
        <translation>按已标注的记录标注…</translation>
    </message>
    <message>
        <source>Labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Labels for points that have none, or that are in pieces, can be learned from recordings of the same marker set.</source>
        <translation>没有标签或断成片段的点，可以从同一标记点方案的记录中学习标签。</translation>
    </message>
    <message>
        <source>Labels are being looked for…</source>
        <translation>正在查找标签…</translation>
    </message>
    <message>
        <source>All points have names that the labelled recordings have.</source>
        <translation>所有点的名称都是已标注记录中有的。</translation>
    </message>
    <message>
        <source>At least {0} % sure: {1} of {2} pieces get a label.</source>
        <translation>把握至少 {0} %：{2} 个片段中有 {1} 个获得标签。</translation>
    </message>
    <message>
        <source>Applied. Undo brings the proposals back.</source>
        <translation>已应用。撤销可恢复建议。</translation>
    </message>
    <message>
        <source>⚠ The recording was edited since: run it again.</source>
        <translation>⚠ 记录此后被编辑过：请重新运行。</translation>
    </message>
    <message>
        <source>{0} (another piece has it)</source>
        <translation>{0} (另一片段占用)</translation>
    </message>
    <message>
        <source>no marker</source>
        <translation>不是标记点</translation>
    </message>
</context>
<context>
    <name>LabelSearch</name>
    <message>
        <source>Labelling</source>
        <translation>标注</translation>
    </message>
    <message>
        <source>Pieces with a proposed label: {0}. Nothing is changed yet.</source>
        <translation>建议了标签的片段：{0} 个。尚未作任何更改。</translation>
    </message>
    <message>
        <source>All points have names that the labelled recordings have.</source>
        <translation>所有点的名称都是已标注记录中有的。</translation>
    </message>
    <message>
        <source>Cancelled: no labels are proposed.</source>
        <translation>已取消：没有建议标签。</translation>
    </message>
</context>
<context>
    <name>LabelTable</name>
    <message>
        <source>Proposed labels</source>
        <translation>建议的标签</translation>
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
        <source>Nobody has said which marker this is.</source>
        <translation>还没有人说明这是哪个标记点。</translation>
    </message>
    <message>
        <source>{0}: never seen in this recording</source>
        <translation>{0}：在此记录中从未出现</translation>
    </message>
    <message>
        <source>{0}: open gaps {1}, longest {2} frames ({3} ms), {4} samples filled</source>
        <translation>{0}：{1} 个未填补的缺失段，最长 {2} 帧 ({3} ms)，已填补 {4} 个采样</translation>
    </message>
    <message>
        <source>{0} samples set aside</source>
        <translation>已搁置 {0} 个采样</translation>
    </message>
    <message>
        <source>{0} samples smoothed: {1}, moved by {2} mm RMS</source>
        <translation>已平滑 {0} 个采样：{1}，移动量均方根 {2} mm</translation>
    </message>
    <message>
        <source>Moves as one with {0}</source>
        <translation>与 {0} 作为整体运动</translation>
    </message>
</context>
<context>
    <name>MarkerNaming</name>
    <message>
        <source>Labels are being looked for already.</source>
        <translation>已在查找标签。</translation>
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
        <source>Smoothed (mm)</source>
        <translation>平滑 (mm)</translation>
    </message>
    <message>
        <source>How far smoothing moved it: RMS, in mm</source>
        <translation>平滑使其移动的距离：均方根，单位 mm</translation>
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
        <source>1 point without a label</source>
        <translation>1 个点没有标签</translation>
    </message>
    <message>
        <source>{0} points without a label</source>
        <translation>{0} 个点没有标签</translation>
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
        <source>Pro&amp;blems</source>
        <translation>问题(&amp;B)</translation>
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
    <name>Methods</name>
    <message>
        <source>Automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>Interpolation</source>
        <translation>插值</translation>
    </message>
    <message>
        <source>Donors</source>
        <translation>参考标记点</translation>
    </message>
    <message>
        <source>Low rank</source>
        <translation>低秩</translation>
    </message>
    <message>
        <source>Sparse</source>
        <translation>稀疏</translation>
    </message>
    <message>
        <source>Kalman</source>
        <translation>卡尔曼</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>常值</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>线性</translation>
    </message>
    <message>
        <source>Cubic spline</source>
        <translation>三次样条</translation>
    </message>
    <message>
        <source>PCHIP</source>
        <translation>PCHIP</translation>
    </message>
    <message>
        <source>Woltring, quintic spline</source>
        <translation>Woltring 五次样条</translation>
    </message>
    <message>
        <source>Cyclic</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>Rigid body</source>
        <translation>刚体</translation>
    </message>
    <message>
        <source>Pattern</source>
        <translation>模式</translation>
    </message>
    <message>
        <source>Local frame regression</source>
        <translation>局部坐标系回归</translation>
    </message>
    <message>
        <source>Principal components, all gaps at once</source>
        <translation>主成分，全部缺失段一次处理</translation>
    </message>
    <message>
        <source>Principal components, marker by marker</source>
        <translation>主成分，逐点</translation>
    </message>
    <message>
        <source>Low-dimensional Kalman smoother</source>
        <translation>低维卡尔曼平滑</translation>
    </message>
    <message>
        <source>Matrix completion of trajectory segments</source>
        <translation>轨迹片段矩阵补全</translation>
    </message>
    <message>
        <source>Sparse code of poses</source>
        <translation>姿态稀疏编码</translation>
    </message>
    <message>
        <source>Sparse code of motion, with bones</source>
        <translation>运动稀疏编码，保持骨长</translation>
    </message>
    <message>
        <source>Sparse motion bases</source>
        <translation>稀疏运动基</translation>
    </message>
    <message>
        <source>Kalman, constant velocity</source>
        <translation>卡尔曼，匀速</translation>
    </message>
    <message>
        <source>Holds the value at one edge of the gap. Right only for a marker that stands still.</source>
        <translation>保持缺失段一端的值。只适用于静止的标记点。</translation>
    </message>
    <message>
        <source>A straight line between the edges of the gap. It cuts every curve of the motion; good for a few frames.</source>
        <translation>在缺失段两端之间连直线。会截去运动中的一切弯曲；只适合几帧的缺失。</translation>
    </message>
    <message>
        <source>A smooth curve through the samples on both sides. Good below about 0.2 s; above, it invents motion and may overshoot.</source>
        <translation>通过两侧采样的光滑曲线。约 0.2 s 以内效果好；更长时会虚构运动，并可能过冲。</translation>
    </message>
    <message>
        <source>A curve that never overshoots the edges of the gap. Safer than the cubic spline on jittery samples, less exact on smooth motion.</source>
        <translation>不会超出缺失段两端数值的曲线。采样抖动时比三次样条稳妥，运动平滑时则不如它精确。</translation>
    </message>
    <message>
        <source>A quintic spline that first smooths the samples beside the gap, by as much as cross-validation says, so that jitter does not swing it. Measured samples stay as they are. Good below about 0.2 s; above, it invents motion and may overshoot further than the cubic spline.</source>
        <translation>五次样条，先按交叉验证给出的程度平滑缺失段旁的采样，使其不受抖动影响。测得的采样保持不变。约 0.2 s 以内效果好；更长时会虚构运动，过冲可能比三次样条更大。</translation>
    </message>
    <message>
        <source>For gait, pedalling and other motion in cycles: takes the same phase of the neighbouring cycles and fits it between the edges of the gap. Good for gaps that span much of a cycle, poor where speed or direction change, as in a turn.</source>
        <translation>用于步态、蹬车等周期性运动：取相邻周期的同一相位，接到缺失段两端之间。适合占周期较大部分的缺失段；速度或方向改变处（如转身）效果差。</translation>
    </message>
    <message>
        <source>Moves the marker with three or more donors that keep their distance to it, such as those of the same segment. Good while that part of the body is stiff; it cannot follow skin and joints.</source>
        <translation>让标记点跟随三个或更多与其距离保持不变的参考标记点（如同一节段上的）。适合该身体部位为刚性的情况；不能跟随皮肤和关节的运动。</translation>
    </message>
    <message>
        <source>Moves the marker along with one donor. For lack of better donors: it does not turn with the body.</source>
        <translation>让标记点跟随一个参考标记点平移。用于没有更好的参考标记点时：它不随身体转动。</translation>
    </message>
    <message>
        <source>Learns from this recording how the marker moves beside its donors, in a frame that moves with four of them. Follows skin and joints as far as the donors show them.</source>
        <translation>在随四个参考标记点运动的坐标系中，从此记录学习该标记点相对参考标记点的运动。参考标记点能体现的皮肤和关节运动都能跟随。</translation>
    </message>
    <message>
        <source>Learns from the complete frames how the markers move together and predicts all markers with gaps at once from those without any (Gløersen and Federolf 2016, R1). For recordings with few gaps; it learns nothing of postures that no complete frame shows.</source>
        <translation>从完整帧学习标记点的共同运动，再由没有缺失段的标记点同时预测全部有缺失段的标记点（Gløersen 与 Federolf 2016，R1）。适合缺失段少的记录；完整帧中没有出现的姿势无法学到。</translation>
    </message>
    <message>
        <source>Learns how the markers move together and predicts each marker with gaps from those that are seen in them, near ones first (Gløersen and Federolf 2016, R2). Good for gaps up to seconds in repetitive motion; poor where a marker&apos;s neighbours are missing too.</source>
        <translation>学习标记点的共同运动，再由缺失段内可见的标记点逐个预测有缺失段的标记点，近者优先（Gløersen 与 Federolf 2016，R2）。适合重复性运动中长达数秒的缺失段；相邻标记点也缺失时效果差。</translation>
    </message>
    <message>
        <source>Learns from the complete frames in which few directions the whole body moves, and follows the posture there with a Kalman smoother (Burke and Lasenby 2016). Fast; good for one marker in motion like that of the complete frames, poor where several markers of a segment are missing.</source>
        <translation>从完整帧学习整个身体运动的少数几个方向，并在其中用卡尔曼平滑器跟踪姿势（Burke 与 Lasenby 2016）。速度快；适合单个标记点缺失且运动与完整帧相似的情况，同一节段多个标记点缺失时效果差。</translation>
    </message>
    <message>
        <source>Completes the trajectories around the gap so that they move in as few directions as possible, near markers counting more (after Tan, Hou and Chau 2013). About as good as the principal components, and often better where several neighbours are missing too; poor where the body turns or moves in the gap as it does nowhere around it.</source>
        <translation>补全缺失段周围的轨迹，使其运动方向尽可能少，近处的标记点权重更大（参照 Tan、Hou 与 Chau 2013）。与主成分法效果相当，多个相邻标记点也缺失时往往更好；缺失段内身体转动或运动方式在其周围不曾出现时效果差。</translation>
    </message>
    <message>
        <source>Composes each pose from few complete ones, of this recording or of a training set, that agree with it in the markers that are seen, and takes the missing marker from them. Good for long gaps where like poses are known; in motion that comes only once, there is nothing to take from.</source>
        <translation>用少数几个完整姿态（取自此记录或训练集，在可见标记点上与之一致）组合出每个姿态，并由此得到缺失的标记点。适合已知相似姿态的长缺失段；只出现一次的运动则无从取用。</translation>
    </message>
    <message>
        <source>Composes each stretch of motion from few examples, of this recording or of a training set, and keeps bone lengths (after Wang, Lu, Han 2018). For several neighbouring markers or joints that are missing together; poor where no example is like the motion.</source>
        <translation>用少数几个样例（取自此记录或训练集）组合出每段运动，并保持骨段长度（参照 Wang、Lu、Han 2018）。适合多个相邻标记点或关节同时缺失；没有相似样例时效果差。</translation>
    </message>
    <message>
        <source>Composes short windows of motion from few examples, part by part and without bones. It is what the sparse code with bones is compared to.</source>
        <translation>用少数几个样例逐个身体部位组合短窗口内的运动，不考虑骨段。用作保持骨长的稀疏编码的比较对象。</translation>
    </message>
    <message>
        <source>Carries position and velocity into the gap from both sides, relative to the neighbouring markers that are seen, and says how sure it is. Where none are, it looks at one marker alone and cannot know what happened inside a gap much longer than 0.2 s.</source>
        <translation>相对于可见的相邻标记点，把位置和速度从两侧带入缺失段，并给出其把握程度。没有可见的相邻标记点时只看该标记点自身，远长于 0.2 s 的缺失段内发生了什么便无从得知。</translation>
    </message>
    <message>
        <source>Learns from this very recording how the marker moves with all others that are seen in the gap. Several such fills are tested on hidden stretches like the gap and blended by how well they did; the expected error and the band come from these tests.</source>
        <translation>从此记录本身学习该标记点与缺失段内所有可见标记点的共同运动。多种填补结果在与缺失段相似的隐藏片段上接受测试，并按表现加权混合；预期误差和置信带由这些测试得出。</translation>
    </message>
    <message>
        <source>Hold the value</source>
        <translation>保持的值</translation>
    </message>
    <message>
        <source>Which value to hold: that before the gap, that after it, or the nearer one.</source>
        <translation>保持哪个值：缺失段之前的、之后的，或较近的。</translation>
    </message>
    <message>
        <source>before</source>
        <translation>之前的</translation>
    </message>
    <message>
        <source>after</source>
        <translation>之后的</translation>
    </message>
    <message>
        <source>nearest</source>
        <translation>最近的</translation>
    </message>
    <message>
        <source>Start and end</source>
        <translation>开头和结尾</translation>
    </message>
    <message>
        <source>What to do with a gap at the start or the end of the recording: leave it open, or hold the nearest sample over all of it.</source>
        <translation>如何处理记录开头或结尾的缺失段：不填补，或全程保持最近的采样。</translation>
    </message>
    <message>
        <source>leave</source>
        <translation>不填补</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>保持</translation>
    </message>
    <message>
        <source>repeat</source>
        <translation>重复</translation>
    </message>
    <message>
        <source>fill</source>
        <translation>填补</translation>
    </message>
    <message>
        <source>Measurement noise</source>
        <translation>测量噪声</translation>
    </message>
    <message>
        <source>Standard deviation of a measured coordinate: so much is smoothed away before the curve enters the gap; 0 smooths nothing. Automatic: generalised cross-validation.</source>
        <translation>测量坐标的标准差：曲线进入缺失段之前平滑掉的程度；0 表示不平滑。自动：广义交叉验证。</translation>
    </message>
    <message>
        <source>Period</source>
        <translation>周期</translation>
    </message>
    <message>
        <source>How long a cycle lasts. Automatic: estimated from the marker, or from all markers where this one alone does not repeat itself.</source>
        <translation>一个周期的时长。自动：由该标记点估计；若它自身不重复，则由全部标记点估计。</translation>
    </message>
    <message>
        <source>What to do with a gap at the start or the end of the recording: leave it open, or repeat the neighbouring cycles there.</source>
        <translation>如何处理记录开头或结尾的缺失段：不填补，或在该处重复相邻周期。</translation>
    </message>
    <message>
        <source>What to do with a gap at the start or the end of the recording: fill it from the other markers, or leave it open.</source>
        <translation>如何处理记录开头或结尾的缺失段：由其他标记点填补，或不填补。</translation>
    </message>
    <message>
        <source>Three or more markers of the same rigid part, by their labels, with commas between them. Automatic: chosen for each gap among the markers that are seen throughout it.</source>
        <translation>同一刚性部位上的三个或更多标记点（即 donors，用来推算缺失标记点），填写其名称，以逗号分隔。自动：为每个缺失段从全程可见的标记点中选取。</translation>
    </message>
    <message>
        <source>A marker that moves like this one, or several, by their labels, with commas between them. Automatic: chosen for each gap among the markers that are seen throughout it.</source>
        <translation>与此标记点运动相似的一个或几个标记点（即 donors），填写其名称，以逗号分隔。自动：为每个缺失段从全程可见的标记点中选取。</translation>
    </message>
    <message>
        <source>Markers that move with this one, by their labels, with commas between them. Automatic: chosen for each gap among the markers that are seen throughout it.</source>
        <translation>与此标记点一起运动的标记点（即 donors），填写其名称，以逗号分隔。自动：为每个缺失段从全程可见的标记点中选取。</translation>
    </message>
    <message>
        <source>Penalty</source>
        <translation>惩罚</translation>
    </message>
    <message>
        <source>Of large coefficients, relative to how much the donors move: more is stiffer.</source>
        <translation>对大系数的惩罚，相对于参考标记点的运动幅度：越大越刚硬。</translation>
    </message>
    <message>
        <source>Meet the edges</source>
        <translation>衔接两端</translation>
    </message>
    <message>
        <source>Carry what the model leaves over at the edges of the gap into it. Off: as printed.</source>
        <translation>把模型在缺失段两端的偏差带入缺失段内加以修正。关闭：按论文原样。</translation>
    </message>
    <message>
        <source>Distance scale</source>
        <translation>距离尺度</translation>
    </message>
    <message>
        <source>Markers much farther away than this from the missing one hardly count.</source>
        <translation>与缺失标记点的距离远大于此值的标记点几乎不计。</translation>
    </message>
    <message>
        <source>Weight of the missing marker</source>
        <translation>缺失标记点的权重</translation>
    </message>
    <message>
        <source>How much the missing marker itself shapes the components, 1 = as much as a marker at its place.</source>
        <translation>缺失标记点自身对主成分的影响，1 = 与处于其位置的标记点相同。</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>主成分</translation>
    </message>
    <message>
        <source>Share of the sum of the singular values that the components kept make up.</source>
        <translation>所保留的主成分占奇异值总和的比例。</translation>
    </message>
    <message>
        <source>Near markers</source>
        <translation>近邻标记点</translation>
    </message>
    <message>
        <source>Markers with gaps of their own help only if they are nearer than this share of the mean distance of all markers.</source>
        <translation>自身有缺失段的标记点，只有在距离小于全部标记点平均距离的这一比例时才参与。</translation>
    </message>
    <message>
        <source>Standard deviation of a measured coordinate. More noise gives smoother postures.</source>
        <translation>测量坐标的标准差。噪声越大，姿势越平滑。</translation>
    </message>
    <message>
        <source>Segments around the gap</source>
        <translation>缺失段周围的片段</translation>
    </message>
    <message>
        <source>How much of the trajectories before and after the gap is looked at, at least as much as the gap is long.</source>
        <translation>查看缺失段前后多长的轨迹，至少与缺失段等长。</translation>
    </message>
    <message>
        <source>Markers much farther away than this from the missing ones hardly count.</source>
        <translation>与各缺失标记点的距离远大于此值的标记点几乎不计。</translation>
    </message>
    <message>
        <source>Weight of the missing markers</source>
        <translation>缺失标记点的权重</translation>
    </message>
    <message>
        <source>How much the missing markers themselves shape the matrix, 1 = as much as a marker at their place.</source>
        <translation>缺失标记点自身对矩阵的影响，1 = 与处于其位置的标记点相同。</translation>
    </message>
    <message>
        <source>Threshold</source>
        <translation>阈值</translation>
    </message>
    <message>
        <source>Singular values below this share of the largest one are taken for noise.</source>
        <translation>小于最大奇异值这一比例的奇异值视为噪声。</translation>
    </message>
    <message>
        <source>Learn from</source>
        <translation>学习来源</translation>
    </message>
    <message>
        <source>Poses to tell this recording&apos;s by, in place of its own complete frames.</source>
        <translation>用来推断此记录姿态的姿态集，代替其自身的完整帧。</translation>
    </message>
    <message>
        <source>Poses</source>
        <translation>姿态数</translation>
    </message>
    <message>
        <source>At most so many known poses, evenly spread, make up the dictionary.</source>
        <translation>字典最多由这么多个均匀分布的已知姿态组成。</translation>
    </message>
    <message>
        <source>The larger, the fewer known poses a pose is made of, and the nearer to the mean pose it is.</source>
        <translation>越大，组成一个姿态的已知姿态越少，且越接近平均姿态。</translation>
    </message>
    <message>
        <source>Markers much farther away than this from the missing one hardly count. As printed, all count alike: 100000 mm.</source>
        <translation>与缺失标记点的距离远大于此值的标记点几乎不计。论文原样为全部等同：100000 mm。</translation>
    </message>
    <message>
        <source>Relative to</source>
        <translation>相对于</translation>
    </message>
    <message>
        <source>What poses are compared by: body = wherever it is and faces, place = wherever it is, world = nothing is taken out, as printed.</source>
        <translation>姿态的比较基准：身体 = 去除位置和朝向，位置 = 去除位置，世界 = 什么都不去除（论文原样）。</translation>
    </message>
    <message>
        <source>body</source>
        <translation>身体</translation>
    </message>
    <message>
        <source>place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>world</source>
        <translation>世界</translation>
    </message>
    <message>
        <source>Mean pose taken out</source>
        <translation>去除平均姿态</translation>
    </message>
    <message>
        <source>Code what differs from the mean pose. Off: as printed.</source>
        <translation>对与平均姿态的差异进行编码。关闭：按论文原样。</translation>
    </message>
    <message>
        <source>Recordings to learn from beside this one. By default it learns from this one alone.</source>
        <translation>除此记录外另用来学习的记录。默认只从此记录学习。</translation>
    </message>
    <message>
        <source>Atoms</source>
        <translation>原子数</translation>
    </message>
    <message>
        <source>Examples of motion in the dictionary. Automatic: up to 150 of the recording, or 600 with a training set.</source>
        <translation>字典中的运动样例数。自动：取自此记录最多 150 个，使用训练集时 600 个。</translation>
    </message>
    <message>
        <source>The larger, the fewer examples a window is made of.</source>
        <translation>越大，组成一个窗口的样例越少。</translation>
    </message>
    <message>
        <source>Dictionary</source>
        <translation>字典</translation>
    </message>
    <message>
        <source>Examples: stretches of motion as they are. Trained: the dictionaries of the five parts of a skeleton that a training set has, as printed in the paper; less exact.</source>
        <translation>样例：原样的运动片段。训练：训练集所含的骨架五个部位的字典，与论文相同；精度较低。</translation>
    </message>
    <message>
        <source>examples</source>
        <translation>样例</translation>
    </message>
    <message>
        <source>trained</source>
        <translation>训练</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窗口</translation>
    </message>
    <message>
        <source>The stretch of motion that is coded as one: six frames spread over it. Automatic: 330 ms, or 600 ms with a training set.</source>
        <translation>作为一个整体编码的运动片段：其中均匀取六帧。自动：330 ms，使用训练集时 600 ms。</translation>
    </message>
    <message>
        <source>Keep bone lengths</source>
        <translation>保持骨段长度</translation>
    </message>
    <message>
        <source>The bones of a skeleton get their exact lengths; markers on skin are pulled towards theirs as far as these are sure.</source>
        <translation>骨架的骨段取其精确长度；皮肤上的标记点按其长度的确定程度向该长度靠拢。</translation>
    </message>
    <message>
        <source>Parts of the body</source>
        <translation>身体部位</translation>
    </message>
    <message>
        <source>Tell each part of the body from itself, the trunk and one more part. Off: from all.</source>
        <translation>由部位自身、躯干和另一个部位推断每个身体部位。关闭：由全部部位推断。</translation>
    </message>
    <message>
        <source>Direction</source>
        <translation>方向</translation>
    </message>
    <message>
        <source>Two-sided uses the samples before and after the gap; causal only those before, as a live system must.</source>
        <translation>双向使用缺失段前后的采样；因果只用之前的，如实时系统那样。</translation>
    </message>
    <message>
        <source>two-sided</source>
        <translation>双向</translation>
    </message>
    <message>
        <source>causal</source>
        <translation>因果</translation>
    </message>
    <message>
        <source>Frame</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>Local: the common rigid motion of the neighbouring markers is taken out first; where fewer than three keep their distance and are seen all along, the world frame is used. World: as printed in the paper.</source>
        <translation>局部：先去除相邻标记点的共同刚体运动；若距离不变且全程可见的标记点少于三个，则用世界坐标系。世界：与论文相同。</translation>
    </message>
    <message>
        <source>local</source>
        <translation>局部</translation>
    </message>
    <message>
        <source>Local frame only: the labels of the markers whose common motion is taken out; one or two are followed without their rotation. Automatic: the four that keep their distance to the marker best.</source>
        <translation>仅用于局部坐标系：去除其共同运动的标记点（即 donors）的名称；只有一两个时跟随其平移而不计转动。自动：与该标记点距离最稳定的四个。</translation>
    </message>
    <message>
        <source>Standard deviation of a measured coordinate. More noise means that more samples beside the gap share in its velocity. Automatic: chosen by self-tests for each gap.</source>
        <translation>测量坐标的标准差。噪声越大，缺失段旁参与估计速度的采样越多。自动：由自测试为每个缺失段选取。</translation>
    </message>
    <message>
        <source>Velocity interval</source>
        <translation>速度区间</translation>
    </message>
    <message>
        <source>Causal only: the fixed interval over which the velocity is taken; 0 takes it between consecutive frames. Automatic: chosen by self-tests for each gap.</source>
        <translation>仅用于因果：计算速度的固定区间；0 表示取相邻两帧之间。自动：由自测试为每个缺失段选取。</translation>
    </message>
    <message>
        <source>Jump</source>
        <translation>跳变</translation>
    </message>
    <message>
        <source>A marker that moves further between two frames was lost or is wrong there, and its samples beside such a jump are not trusted. A large number switches this off. Automatic: estimated from the motion of each marker.</source>
        <translation>两帧之间移动超过此值的标记点在该处已丢失或有误，跳变旁的采样不予采信。填大数可关闭此项。自动：由各标记点的运动估计。</translation>
    </message>
    <message>
        <source>Gate</source>
        <translation>门限</translation>
    </message>
    <message>
        <source>A single sample beside the gap is not trusted if it lies more than this many standard deviations from what the filter makes of the others. A large number switches this off.</source>
        <translation>缺失段旁的单个采样若与滤波器由其他采样得出的值相差超过这么多个标准差，则不予采信。填大数可关闭此项。</translation>
    </message>
    <message>
        <source>Pull to bone lengths</source>
        <translation>拉向骨段长度</translation>
    </message>
    <message>
        <source>Moves the predicted points towards the lengths of the bones to up to four markers at a nearly constant distance, as far as the filter is unsure and the lengths are not.</source>
        <translation>使预测点与最多四个距离近乎不变的标记点之间的骨段趋于其长度；滤波器越不确定、长度越确定，修正越大。</translation>
    </message>
    <message>
        <source>Recordings to learn from beside this one. Windows of motion that are coded by them, as in bone-dictionary, become part of the blend as far as tests speak for it; bones of a skeleton get their exact lengths. This takes seconds a gap.</source>
        <translation>除此记录外另用来学习的记录。用其编码的运动窗口（同 bone-dictionary）在测试支持时参与混合；骨架的骨段取其精确长度。每个缺失段需数秒。</translation>
    </message>
    <message>
        <source>Butterworth, zero lag</source>
        <translation>巴特沃斯，零相位</translation>
    </message>
    <message>
        <source>Takes away what is faster than a cut-off frequency, forwards and backwards so that nothing is delayed. The common choice of biomechanics; it rounds off impacts.</source>
        <translation>去除快于截止频率的成分，正反各滤波一次，因此没有延迟。生物力学中的常用选择；会磨圆冲击。</translation>
    </message>
    <message>
        <source>Cut-off</source>
        <translation>截止频率</translation>
    </message>
    <message>
        <source>Motion faster than this is taken for noise: where the power is halved. Automatic: residual analysis.</source>
        <translation>比它更快的运动视为噪声：功率减半之处。自动：残差分析。</translation>
    </message>
    <message>
        <source>Choose for</source>
        <translation>选择范围</translation>
    </message>
    <message>
        <source>Automatic cut-off only: one for each axis of each marker, one for each marker, or one for all that is smoothed.</source>
        <translation>仅用于自动截止频率：每个标记点的每个坐标轴各一个、每个标记点一个，或全部平滑内容共用一个。</translation>
    </message>
    <message>
        <source>axis</source>
        <translation>坐标轴</translation>
    </message>
    <message>
        <source>marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>Rule</source>
        <translation>准则</translation>
    </message>
    <message>
        <source>Automatic cut-off only. Least error: the cut-off with the least expected error, given the noise that residual analysis finds. Winter: where the residual equals the noise, which smooths more.</source>
        <translation>仅用于自动截止频率。最小误差：在残差分析得出的噪声下预期误差最小的截止频率。Winter：残差等于噪声之处，平滑更多。</translation>
    </message>
    <message>
        <source>least-error</source>
        <translation>最小误差</translation>
    </message>
    <message>
        <source>winter</source>
        <translation>Winter 法</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>阶数</translation>
    </message>
    <message>
        <source>Of the filter that goes forwards and backwards, both ways together: an even number. Higher cuts more sharply and rings more beside impacts.</source>
        <translation>正反两次滤波合计的阶数，须为偶数。越高截止越陡，冲击旁的振铃也越多。</translation>
    </message>
    <message>
        <source>Savitzky-Golay</source>
        <translation>Savitzky-Golay 滤波</translation>
    </message>
    <message>
        <source>Fits a polynomial to a short stretch around each sample. Keeps the height of peaks better than most; what is faster than its window is not taken away completely.</source>
        <translation>对每个采样周围的一小段拟合多项式。比多数方法更能保持峰值高度；快于其窗口的成分不会完全去除。</translation>
    </message>
    <message>
        <source>How long the stretch is that a polynomial is fitted to, around each sample: the nearest odd number of frames. Automatic: the one with the best cross-validation score, up to half a second.</source>
        <translation>每个采样周围拟合多项式的时长，取最接近的奇数帧。自动：交叉验证得分最好者，最长半秒。</translation>
    </message>
    <message>
        <source>Of the polynomial. Higher follows impacts better and smooths less.</source>
        <translation>多项式的阶数。越高越能跟随冲击，平滑越少。</translation>
    </message>
    <message>
        <source>A quintic spline that smooths by as much as generalised cross-validation says, and less at impacts. Good where speeds and accelerations are wanted; jitter that lasts for several frames is taken for motion.</source>
        <translation>五次样条，平滑程度由广义交叉验证决定，冲击处平滑较少。适合需要速度和加速度的情况；持续数帧的抖动会被当作运动。</translation>
    </message>
    <message>
        <source>Motion faster than this is taken for noise: where the power is halved. Automatic: generalised cross-validation, or the measurement noise where it is given.</source>
        <translation>比它更快的运动视为噪声：功率减半之处。自动：广义交叉验证；给出测量噪声时以其为准。</translation>
    </message>
    <message>
        <source>Standard deviation of a measured coordinate: about so much is smoothed away. Automatic: generalised cross-validation.</source>
        <translation>测量坐标的标准差：大约平滑掉这么多。自动：广义交叉验证。</translation>
    </message>
    <message>
        <source>Keep impacts</source>
        <translation>保留冲击</translation>
    </message>
    <message>
        <source>Smooths less where the motion is much faster than elsewhere, as at a foot strike or a kick. Off: as much everywhere, as Woltring&apos;s program does.</source>
        <translation>在运动远快于别处的地方（如着地或踢击）平滑较少。关闭：各处同样平滑，与 Woltring 的程序一致。</translation>
    </message>
    <message>
        <source>Kalman smoother</source>
        <translation>卡尔曼平滑器</translation>
    </message>
    <message>
        <source>Weighs each sample against what the motion around it lets expect. How fast the motion changes and how noisy the samples are is estimated from the samples.</source>
        <translation>将每个采样与其周围运动的预期加权。运动变化的快慢和采样的噪声由采样本身估计。</translation>
    </message>
    <message>
        <source>What is carried from frame to frame: the velocity, or the acceleration too, which makes a smoother curve and rounds off more of an impact.</source>
        <translation>逐帧延续的量：速度，或连同加速度；后者曲线更平滑，但对冲击磨圆更多。</translation>
    </message>
    <message>
        <source>velocity</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>acceleration</source>
        <translation>加速度</translation>
    </message>
    <message>
        <source>Standard deviation of a measured coordinate. Automatic: estimated together with how fast the motion changes.</source>
        <translation>测量坐标的标准差。自动：与运动变化的快慢一同估计。</translation>
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
    <name>ModelCard</name>
    <message>
        <source>About</source>
        <translation>简介</translation>
    </message>
    <message>
        <source>Trained on</source>
        <translation>训练数据</translation>
    </message>
    <message>
        <source>Held out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>Made by</source>
        <translation>制作命令</translation>
    </message>
    <message>
        <source>nothing is said</source>
        <translation>没有说明</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>无</translation>
    </message>
    <message>
        <source>nobody says</source>
        <translation>没有说明</translation>
    </message>
    <message>
        <source>network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>network, 6 Hz</source>
        <translation>网络，6 Hz</translation>
    </message>
    <message>
        <source>ridge on 5 Hz Butterworth</source>
        <translation>5 Hz 巴特沃斯滤波后的岭回归</translation>
    </message>
    <message>
        <source>Nothing was held out: how good it is was not measured.</source>
        <translation>没有留出数据：其优劣未经测量。</translation>
    </message>
    <message>
        <source>Lp: mean square error of a coordinate. Lb: of bone lengths. Ls: mean square second difference of a coordinate.</source>
        <translation>Lp：坐标的均方误差。Lb：骨段长度的均方误差。Ls：坐标二阶差分的均方值。</translation>
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
    <name>NetworkBox</name>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>none is chosen</source>
        <translation>未选择</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>选择文件…</translation>
    </message>
    <message>
        <source>Choose a network</source>
        <translation>选择网络</translation>
    </message>
    <message>
        <source>Networks (*.npz)</source>
        <translation>网络 (*.npz)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
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
    <name>Panes</name>
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
        <source>Plan</source>
        <translation>计划</translation>
    </message>
    <message>
        <source>Repairs</source>
        <translation>修复列表</translation>
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
        <source>Labels</source>
        <translation>标签</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Analog</source>
        <translation>模拟通道</translation>
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
<context>
    <name>ParamsForm</name>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
</context>
<context>
    <name>PathField</name>
    <message>
        <source>Browse…</source>
        <translation>浏览…</translation>
    </message>
    <message>
        <source>Browse: {0}</source>
        <translation>浏览：{0}</translation>
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
        <source>Gaps, by {0}: {1} would be filled (samples: {2}), {3} would stay open.</source>
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
        <source>{0} Stretches smoothed again: {1}.</source>
        <translation>{0} 已重新平滑的区段：{1} 个。</translation>
    </message>
    <message>
        <source>The recipe has nothing to do here.</source>
        <translation>该修复方案在此处没有可做的操作。</translation>
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
    <name>Proofs</name>
    <message>
        <source>Not exported yet.</source>
        <translation>尚未导出。</translation>
    </message>
    <message>
        <source>Edited since {0} was exported.</source>
        <translation>导出 {0} 之后又有编辑。</translation>
    </message>
</context>
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>Drive</source>
        <translation>驱动器</translation>
    </message>
    <message>
        <source>File</source>
        <translation>文件</translation>
    </message>
    <message>
        <source>%1 File</source>
        <translation>%1 文件</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>文件夹</translation>
    </message>
    <message>
        <source>Shortcut</source>
        <translation>快捷方式</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>未知</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>&amp;Look in:</source>
        <translation>查找范围(&amp;L)：</translation>
    </message>
    <message>
        <source>Files of &amp;type:</source>
        <translation>文件类型(&amp;T)：</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Size</source>
        <translation>大小</translation>
    </message>
</context>
<context>
    <name>QKeySequenceEdit</name>
    <message>
        <source>Press shortcut</source>
        <translation>按下快捷键</translation>
    </message>
</context>
<context>
    <name>QueueModel</name>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类型</translation>
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
        <source>What has become of the problem</source>
        <translation>问题的处理情况</translation>
    </message>
    <message>
        <source>A gap, or what is wrong with the samples</source>
        <translation>缺失段，或采样的问题所在</translation>
    </message>
    <message>
        <source>Frames that are missing or bad</source>
        <translation>缺失或坏的帧数</translation>
    </message>
    <message>
        <source>Expected error of the best repair that was tried, or how far bad samples are off, in mm</source>
        <translation>已试过的最佳修复的预期误差，或坏采样的偏差，单位 mm</translation>
    </message>
    <message>
        <source>Error times frames: what comes first is worst</source>
        <translation>误差乘以帧数：排在最前的最严重</translation>
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
        <source>Beyond the limits</source>
        <translation>超出限值</translation>
    </message>
    <message>
        <source>Left open</source>
        <translation>保留未填</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>长度</translation>
    </message>
    <message>
        <source>Kind of problem</source>
        <translation>问题的类型</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>查找</translation>
    </message>
    <message>
        <source>Look for bad samples in the background</source>
        <translation>在后台查找坏采样</translation>
    </message>
    <message>
        <source>Never to be filled</source>
        <translation>永不填补</translation>
    </message>
    <message>
        <source>No problem</source>
        <translation>没有问题</translation>
    </message>
    <message>
        <source>All</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>All kinds</source>
        <translation>所有类型</translation>
    </message>
    <message>
        <source>Gaps</source>
        <translation>缺失段</translation>
    </message>
    <message>
        <source>Bad samples</source>
        <translation>坏采样</translation>
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
        <source>No problem passes the filter.</source>
        <translation>没有符合筛选条件的问题。</translation>
    </message>
    <message>
        <source>No bad samples were found.</source>
        <translation>没有找到坏采样。</translation>
    </message>
    <message>
        <source>Bad samples are being looked for…</source>
        <translation>正在查找坏采样…</translation>
    </message>
    <message>
        <source>Bad samples were not looked for: Ctrl+F does it.</source>
        <translation>尚未查找坏采样：按 Ctrl+F 查找。</translation>
    </message>
    <message>
        <source>{0} listed · ranked {1} of {2}</source>
        <translation>列出 {0} 项 · 已排序 {1} / {2}</translation>
    </message>
    <message>
        <source>1 problem</source>
        <translation>1 个问题</translation>
    </message>
    <message>
        <source>{0} problems</source>
        <translation>{0} 个问题</translation>
    </message>
    <message>
        <source>1 gap</source>
        <translation>1 个缺失段</translation>
    </message>
    <message>
        <source>No marker is missing anywhere: there is nothing to fill.</source>
        <translation>没有标记点缺失：无需填补。</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>已处理</translation>
    </message>
    <message>
        <source>Gaps that are repaired, and problems that are fixed</source>
        <translation>已修复的缺失段和已修正的问题</translation>
    </message>
    <message>
        <source>{0} gaps</source>
        <translation>{0} 个缺失段</translation>
    </message>
</context>
<context>
    <name>QueueTable</name>
    <message>
        <source>Queue of problems</source>
        <translation>问题队列</translation>
    </message>
    <message>
        <source>inside, {0} more missing</source>
        <translation>中间，另缺 {0} 个</translation>
    </message>
</context>
<context>
    <name>QueueTexts</name>
    <message>
        <source>open</source>
        <translation>未填补</translation>
    </message>
    <message>
        <source>beyond the limits</source>
        <translation>超出限值</translation>
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
        <source>found</source>
        <translation>已找到</translation>
    </message>
    <message>
        <source>fixed</source>
        <translation>已修正</translation>
    </message>
    <message>
        <source>no problem</source>
        <translation>没有问题</translation>
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
    <name>ReasonDialog</name>
    <message>
        <source>Why it stays open</source>
        <translation>为何不填补</translation>
    </message>
    <message>
        <source>{0}, frames {1}</source>
        <translation>{0}，第 {1} 帧</translation>
    </message>
    <message>
        <source>{0}, frame {1}</source>
        <translation>{0}，第 {1} 帧</translation>
    </message>
    <message>
        <source>{0} gaps</source>
        <translation>{0} 个缺失段</translation>
    </message>
    <message>
        <source>Left open from now on, for this reason:</source>
        <translation>从现在起保留不填补，原因：</translation>
    </message>
    <message>
        <source>Never to be filled, for this reason:</source>
        <translation>永不填补，原因：</translation>
    </message>
    <message>
        <source>Kept open, for this reason:</source>
        <translation>保留不填补，原因：</translation>
    </message>
    <message>
        <source>The reason</source>
        <translation>原因</translation>
    </message>
    <message>
        <source>Type why, or choose below (↑ ↓)</source>
        <translation>输入原因，或在下方选择（↑ ↓）</translation>
    </message>
    <message>
        <source>Usual reasons</source>
        <translation>常见原因</translation>
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
    <name>RefineActions</name>
    <message>
        <source>Refining {0}</source>
        <translation>正在精修 {0}</translation>
    </message>
    <message>
        <source>{0} markers computed in {1} frames, none measured: {2}</source>
        <translation>在 {1} 帧中计算出 {0} 个标记点，均非测得：{2}</translation>
    </message>
    <message>
        <source>Joints that were missing at times were bridged: {0}.</source>
        <translation>有时缺失的关节已补上：{0}。</translation>
    </message>
</context>
<context>
    <name>RefineChecks</name>
    <message>
        <source>There is no reference of this name.</source>
        <translation>没有这个名称的参考记录。</translation>
    </message>
    <message>
        <source>To calibrate, give a recording and its reference.</source>
        <translation>若要校准，请同时给出一个记录及其参考。</translation>
    </message>
    <message>
        <source>There is no recording of this name to calibrate with.</source>
        <translation>没有此名称的用于校准的记录。</translation>
    </message>
    <message>
        <source>A recording cannot calibrate itself.</source>
        <translation>记录不能用来校准自己。</translation>
    </message>
    <message>
        <source>Say where the outcome goes.</source>
        <translation>请指定结果存放的位置。</translation>
    </message>
    <message>
        <source>The name of the outcome must end in one of {0}.</source>
        <translation>结果的文件名必须以 {0} 之一结尾。</translation>
    </message>
    <message>
        <source>There is no folder for the outcome.</source>
        <translation>存放结果的文件夹不存在。</translation>
    </message>
    <message>
        <source>The outcome must not replace one of the other recordings.</source>
        <translation>结果不得替换其他记录之一。</translation>
    </message>
</context>
<context>
    <name>RefineDialog</name>
    <message>
        <source>Refine by a network</source>
        <translation>用网络精修</translation>
    </message>
    <message>
        <source>What is known of the network</source>
        <translation>关于此网络的已知情况</translation>
    </message>
    <message>
        <source>Stride</source>
        <translation>步长</translation>
    </message>
    <message>
        <source>Low-pass at</source>
        <translation>低通，截止频率</translation>
    </message>
    <message>
        <source>Smooths the outcome, without lag; 6 Hz is usual</source>
        <translation>对结果作零相位平滑；通常取 6 Hz</translation>
    </message>
    <message>
        <source>Reference</source>
        <translation>参考记录</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>What a better system has recorded meanwhile, with the markers that come out: the outcome is measured against it</source>
        <translation>由更好的系统同时采集、含有所输出标记点的记录：结果以它为准来衡量</translation>
    </message>
    <message>
        <source>Calibrate with</source>
        <translation>校准用记录</translation>
    </message>
    <message>
        <source>Another recording of the same person with the same sensor, of which there is a reference: the mean error of each marker there is subtracted</source>
        <translation>同一人用同一传感器的另一个记录，且有其参考：将减去其中每个标记点的平均误差</translation>
    </message>
    <message>
        <source>Its reference</source>
        <translation>其参考</translation>
    </message>
    <message>
        <source>What a better system has recorded meanwhile</source>
        <translation>更好的系统同时记录的数据</translation>
    </message>
    <message>
        <source>Outcome</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>Why it cannot be refined</source>
        <translation>不能精修的原因</translation>
    </message>
    <message>
        <source>Output filter</source>
        <translation>输出滤波</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>精修</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>网络</translation>
    </message>
    <message>
        <source>The joints are taken as the file has measured them: edits are left out.</source>
        <translation>关节按文件中测得的数据采用：不含编辑。</translation>
    </message>
    <message>
        <source>The file is truncated: what is there of it is refined.</source>
        <translation>文件被截断：只精修现有的部分。</translation>
    </message>
    <message>
        <source>Choose a network: a file that “mocapmend train refine” has written.</source>
        <translation>请选择网络：由“mocapmend train refine”写出的文件。</translation>
    </message>
    <message>
        <source>60: the middle 60 frames of each window of 120 ({0})</source>
        <translation>60：每个 120 帧窗口取中间 60 帧（{0}）</translation>
    </message>
    <message>
        <source>1: the middle frame of each window, as in the paper ({0})</source>
        <translation>1：每个窗口取中间一帧，与论文相同（{0}）</translation>
    </message>
    <message>
        <source>less than a second</source>
        <translation>不到一秒</translation>
    </message>
    <message>
        <source>about {0} s</source>
        <translation>约 {0} 秒</translation>
    </message>
    <message>
        <source>about {0} min</source>
        <translation>约 {0} 分钟</translation>
    </message>
    <message>
        <source>This network takes other joints ({0}): {1} of {2} are not here: {3}.</source>
        <translation>此网络使用的是其他关节（{0}）：其 {2} 个中有 {1} 个不在此记录中：{3}。</translation>
    </message>
    <message>
        <source>What the recording has are the joints of another profile ({0}); one never stands for the other.</source>
        <translation>此记录具有的是另一种配置的关节（{0}）；两者不能互相代替。</translation>
    </message>
    <message>
        <source>A network for them can be trained with “mocapmend train refine”.</source>
        <translation>可以用“mocapmend train refine”为这些关节训练网络。</translation>
    </message>
    <message>
        <source>These joints are there more than once: {0}.</source>
        <translation>这些关节出现不止一次：{0}。</translation>
    </message>
    <message>
        <source>These joints are never seen: {0}.</source>
        <translation>这些关节从未被看到：{0}。</translation>
    </message>
    <message>
        <source>Reference recording</source>
        <translation>参考记录</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>所有文件 (*)</translation>
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
        <source>NumPy (*.npz)</source>
        <translation>NumPy (*.npz)</translation>
    </message>
    <message>
        <source>Where the outcome goes</source>
        <translation>结果存放的位置</translation>
    </message>
    <message>
        <source>There is a file of this name. Replace {0}?</source>
        <translation>已有同名文件。要替换 {0} 吗？</translation>
    </message>
</context>
<context>
    <name>RefinementPage</name>
    <message>
        <source>How the recording was refined</source>
        <translation>记录是如何精修的</translation>
    </message>
    <message>
        <source>Errors against the reference</source>
        <translation>相对参考记录的误差</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>记录</translation>
    </message>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>RMS distance (mm)</source>
        <translation>均方根距离 (mm)</translation>
    </message>
    <message>
        <source>Distances from the reference</source>
        <translation>到参考记录的距离</translation>
    </message>
    <message>
        <source>output filter {0}</source>
        <translation>输出滤波 {0}</translation>
    </message>
    <message>
        <source>Network: {0}</source>
        <translation>网络：{0}</translation>
    </message>
    <message>
        <source>Stride {0}, {1}</source>
        <translation>步长 {0}，{1}</translation>
    </message>
    <message>
        <source>no output filter</source>
        <translation>无输出滤波</translation>
    </message>
    <message>
        <source>Calibrated by recordings of the same person: {0}</source>
        <translation>用同一人的记录校准：{0} 个</translation>
    </message>
    <message>
        <source>Reference: {0}, {1} frames at 60 Hz, lag {2} ms</source>
        <translation>参考记录：{0}，60 Hz 的 {1} 帧，时间差 {2} ms</translation>
    </message>
    <message>
        <source>refined</source>
        <translation>精修结果</translation>
    </message>
    <message>
        <source>reference itself</source>
        <translation>参考记录本身</translation>
    </message>
</context>
<context>
    <name>RenamingActions</name>
    <message>
        <source>{0} is called {1} now.</source>
        <translation>{0} 现在叫 {1}。</translation>
    </message>
    <message>
        <source>⚠ {0} is called {1} now, as another marker is.</source>
        <translation>⚠ {0} 现在叫 {1}，与另一个标记点同名。</translation>
    </message>
    <message>
        <source>Select the two markers whose names are to be exchanged (Ctrl+click adds one).</source>
        <translation>请选择要交换名称的两个标记点（Ctrl+单击可添加）。</translation>
    </message>
    <message>
        <source>Both have the same name.</source>
        <translation>两者名称相同。</translation>
    </message>
    <message>
        <source>{0} and {1} have each other&apos;s name now.</source>
        <translation>{0} 与 {1} 已交换名称。</translation>
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
        <source>Kept open: {0}</source>
        <translation>保留不填补：{0}</translation>
    </message>
    <message>
        <source>Open gaps: {0}</source>
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
        <source>frame {0} ({1} ms)</source>
        <translation>帧 {0} ({1} ms)</translation>
    </message>
    <message>
        <source>frames {0} – {1}: {2} ({3} ms)</source>
        <translation>帧 {0} – {1}：{2} 帧 ({3} ms)</translation>
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
        <source>Measured on 1 hidden stretch of {1}.</source>
        <translation>在{1}的 1 个隐藏片段上测得。</translation>
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
        <translation>，90&#xa0;%&#xa0;在&#xa0;{0}&#xa0;mm&#xa0;内</translation>
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
        <source>Refinement</source>
        <translation>精修</translation>
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
    <name>ResidualPlot</name>
    <message>
        <source>Residual by cut-off</source>
        <translation>残差与截止频率</translation>
    </message>
    <message>
        <source>What the filter takes away, in mm, by its cut-off. Dashed: what it would take of noise alone. Dot: the cut-off. Click to give another one.</source>
        <translation>滤波器在各截止频率下去除的量，单位 mm。虚线：仅有噪声时会去除的量。圆点：截止频率。点击可另行指定。</translation>
    </message>
    <message>
        <source>{0}: cut-off {1} Hz, noise {2} mm</source>
        <translation>{0}：截止频率 {1} Hz，噪声 {2} mm</translation>
    </message>
    <message>
        <source>mm by Hz</source>
        <translation>残差 mm / Hz</translation>
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
    <message>
        <source>Squat, 22 joints of a Kinect, to refine</source>
        <translation>深蹲，Kinect 的 22 个关节，可供精修</translation>
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
    <message>
        <source>that is what it was made from</source>
        <translation>此记录由它得出</translation>
    </message>
    <message>
        <source>in its own place</source>
        <translation>在其原位置</translation>
    </message>
    <message>
        <source>turned and shifted to fit, lag {0} ms</source>
        <translation>已旋转和平移以相合，时间差 {0} ms</translation>
    </message>
</context>
<context>
    <name>ScenePicture</name>
    <message>
        <source>3D marker view</source>
        <translation>标记点三维视图</translation>
    </message>
    <message>
        <source>Picking donors: click markers; D ends it</source>
        <translation>正在选取参考标记点：点击标记点；按 D 结束</translation>
    </message>
    <message>
        <source>Segments: none are known for this recording</source>
        <translation>节段：此记录没有已知的节段</translation>
    </message>
</context>
<context>
    <name>Segments</name>
    <message>
        <source>head</source>
        <translation>头部</translation>
    </message>
    <message>
        <source>thorax</source>
        <translation>胸廓</translation>
    </message>
    <message>
        <source>pelvis</source>
        <translation>骨盆</translation>
    </message>
    <message>
        <source>left upper arm</source>
        <translation>左上臂</translation>
    </message>
    <message>
        <source>right upper arm</source>
        <translation>右上臂</translation>
    </message>
    <message>
        <source>left forearm</source>
        <translation>左前臂</translation>
    </message>
    <message>
        <source>right forearm</source>
        <translation>右前臂</translation>
    </message>
    <message>
        <source>left hand</source>
        <translation>左手</translation>
    </message>
    <message>
        <source>right hand</source>
        <translation>右手</translation>
    </message>
    <message>
        <source>left thigh</source>
        <translation>左大腿</translation>
    </message>
    <message>
        <source>right thigh</source>
        <translation>右大腿</translation>
    </message>
    <message>
        <source>left shank</source>
        <translation>左小腿</translation>
    </message>
    <message>
        <source>right shank</source>
        <translation>右小腿</translation>
    </message>
    <message>
        <source>left foot</source>
        <translation>左足</translation>
    </message>
    <message>
        <source>right foot</source>
        <translation>右足</translation>
    </message>
</context>
<context>
    <name>Sentences</name>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>The files are the same, byte for byte.</source>
        <translation>两个文件逐字节相同。</translation>
    </message>
    <message>
        <source>Check passed: {0} changed; but for the differences that are allowed, all else is the same.</source>
        <translation>检查通过：更改了 {0}；除允许的差异外，其余完全相同。</translation>
    </message>
    <message>
        <source>Check passed: {0} changed; all else is the same, byte for byte.</source>
        <translation>检查通过：更改了 {0}；其余逐字节相同。</translation>
    </message>
    <message>
        <source>Check failed: {0} changed, and there is more: {1}.</source>
        <translation>检查未通过：更改了 {0}，此外还有：{1}。</translation>
    </message>
    <message>
        <source>1 marker sample in 1 run</source>
        <translation>1 个连续段中的 1 个标记点采样</translation>
    </message>
    <message>
        <source>{0} marker samples in 1 run</source>
        <translation>1 个连续段中的 {0} 个标记点采样</translation>
    </message>
    <message>
        <source>{0} marker samples in {1} runs</source>
        <translation>{1} 个连续段中的 {0} 个标记点采样</translation>
    </message>
    <message>
        <source>0 marker samples</source>
        <translation>0 个标记点采样</translation>
    </message>
    <message>
        <source>1 other difference</source>
        <translation>1 处其他差异</translation>
    </message>
    <message>
        <source>{0} other differences</source>
        <translation>{0} 处其他差异</translation>
    </message>
    <message>
        <source>The sizes differ: {0} and {1} bytes.</source>
        <translation>大小不同：{0} 与 {1} 字节。</translation>
    </message>
    <message>
        <source>The repair record names another original.</source>
        <translation>修复记录指向另一个原文件。</translation>
    </message>
    <message>
        <source>Integers became floats, and no repair record says so.</source>
        <translation>整数变成了浮点数，而修复记录没有说明。</translation>
    </message>
    <message>
        <source>{0} measured sample at the ends of repaired gaps were replaced; the repair record lists them.</source>
        <translation>已修复缺失段两端的 {0} 个测量采样被替换；修复记录中已列出。</translation>
    </message>
    <message>
        <source>{0} measured samples at the ends of repaired gaps were replaced; the repair record lists them.</source>
        <translation>已修复缺失段两端的 {0} 个测量采样被替换；修复记录中已列出。</translation>
    </message>
    <message>
        <source>The parameters hold the repair record; it moved the data by {0} block.</source>
        <translation>参数中含有修复记录；它使数据移动了 {0} 个块。</translation>
    </message>
    <message>
        <source>The parameters hold the repair record; it moved the data by {0} blocks.</source>
        <translation>参数中含有修复记录；它使数据移动了 {0} 个块。</translation>
    </message>
    <message>
        <source>The repair record was taken out of the parameters ({0} blocks).</source>
        <translation>修复记录已从参数中取出（{0} 个块）。</translation>
    </message>
    <message>
        <source>The integers of the file became floats; all values that were not repaired are equal.</source>
        <translation>文件中的整数变成了浮点数；所有未修复的值都相等。</translation>
    </message>
    <message>
        <source>1 byte differs in {0}.</source>
        <translation>{0}中有 1 个字节不同。</translation>
    </message>
    <message>
        <source>{0} bytes differ in {1}.</source>
        <translation>{1}中有 {0} 个字节不同。</translation>
    </message>
    <message>
        <source>the header</source>
        <translation>文件头</translation>
    </message>
    <message>
        <source>blocks that nothing uses</source>
        <translation>未使用的块</translation>
    </message>
    <message>
        <source>the structure of the parameter section</source>
        <translation>参数区的结构</translation>
    </message>
    <message>
        <source>the parameter {0}</source>
        <translation>参数 {0}</translation>
    </message>
    <message>
        <source>what follows the last frame</source>
        <translation>最后一帧之后的内容</translation>
    </message>
    <message>
        <source>1 sample differs</source>
        <translation>1 个采样不同</translation>
    </message>
    <message>
        <source>{0} samples differ</source>
        <translation>{0} 个采样不同</translation>
    </message>
    <message>
        <source>1 value differs</source>
        <translation>1 个值不同</translation>
    </message>
    <message>
        <source>{0} values differ</source>
        <translation>{0} 个值不同</translation>
    </message>
    <message>
        <source>Model output {0}: {1}, the first at frame {2}.</source>
        <translation>模型输出 {0}：{1}，首个在第 {2} 帧。</translation>
    </message>
    <message>
        <source>Marker {0}: {1} although measured, the first at frame {2}.</source>
        <translation>标记点 {0}：虽为测量值，仍有 {1}，首个在第 {2} 帧。</translation>
    </message>
    <message>
        <source>Marker {0}: {1}, and still missing, the first at frame {2}.</source>
        <translation>标记点 {0}：{1}，且仍然缺失，首个在第 {2} 帧。</translation>
    </message>
    <message>
        <source>Marker {0}: {1} without the mark of a computed sample (fourth word 0), the first at frame {2}.</source>
        <translation>标记点 {0}：{1}，没有计算采样的标记（第四个字为 0），首个在第 {2} 帧。</translation>
    </message>
    <message>
        <source>Marker {0}: {1} without an entry in the repair record, the first at frame {2}.</source>
        <translation>标记点 {0}：{1}，修复记录中没有条目，首个在第 {2} 帧。</translation>
    </message>
    <message>
        <source>Marker {0}: {1} although the repair record keeps the gap open, the first at frame {2}.</source>
        <translation>标记点 {0}：{1}，而修复记录规定该缺失段不填补，首个在第 {2} 帧。</translation>
    </message>
    <message>
        <source>Analog channel {0}: {1}.</source>
        <translation>模拟通道 {0}：{1}。</translation>
    </message>
    <message>
        <source>The c3d library read {0} frames of both files: {1} of {2} written samples decode as they should, and all else is the same.</source>
        <translation>c3d 库读取了两个文件的 {0} 帧：写入的 {2} 个采样中有 {1} 个解码正确，其余完全相同。</translation>
    </message>
    <message>
        <source>No second check, the c3d library cannot read this file: {0}.</source>
        <translation>没有第二次检查，c3d 库无法读取此文件：{0}。</translation>
    </message>
    <message>
        <source>The file was read back: all samples are as they should be.</source>
        <translation>文件已回读：所有采样都正确。</translation>
    </message>
    <message>
        <source>The repair record is in the file, as parameter group {0}.</source>
        <translation>修复记录在文件中，为参数组 {0}。</translation>
    </message>
    <message>
        <source>The repair record is beside the file: {0}.</source>
        <translation>修复记录在文件旁边：{0}。</translation>
    </message>
    <message>
        <source>The file did not read back as it was written ({0}); it was removed.</source>
        <translation>文件回读的结果与写入的不同 ({0})；已将其删除。</translation>
    </message>
    <message>
        <source>Check the disk, or choose another one.</source>
        <translation>请检查磁盘，或换一个磁盘。</translation>
    </message>
    <message>
        <source>The file cannot be written: {0}.</source>
        <translation>无法写入文件：{0}。</translation>
    </message>
    <message>
        <source>Choose another place.</source>
        <translation>请换一个位置。</translation>
    </message>
    <message>
        <source>The folder does not exist.</source>
        <translation>文件夹不存在。</translation>
    </message>
    <message>
        <source>Create it or choose another.</source>
        <translation>请创建它或换一个。</translation>
    </message>
    <message>
        <source>You may not write into this folder.</source>
        <translation>您没有写入此文件夹的权限。</translation>
    </message>
    <message>
        <source>Choose another one.</source>
        <translation>请换一个。</translation>
    </message>
    <message>
        <source>There is not enough space for the file.</source>
        <translation>空间不足，无法写入文件。</translation>
    </message>
    <message>
        <source>Free some space or choose another folder.</source>
        <translation>请腾出空间或换一个文件夹。</translation>
    </message>
    <message>
        <source>There is a folder or a device of this name.</source>
        <translation>已有同名的文件夹或设备。</translation>
    </message>
    <message>
        <source>Choose another name.</source>
        <translation>请换一个名称。</translation>
    </message>
    <message>
        <source>Marker {0} at frame {1}: {2} {3} does not fit into the {4} of this file, which end at {5}.</source>
        <translation>标记点 {0} 第 {1} 帧：{2} {3} 超出此文件的 {4} 所能表示的上限 {5}。</translation>
    </message>
    <message>
        <source>Leave this sample out, or fill it in another way.</source>
        <translation>请略去此采样，或用其他方法填补。</translation>
    </message>
    <message>
        <source>The file is empty.</source>
        <translation>文件是空的。</translation>
    </message>
    <message>
        <source>This is not a C3D file.</source>
        <translation>这不是 C3D 文件。</translation>
    </message>
    <message>
        <source>The file ends before its parameter section, or does not say where that is.</source>
        <translation>文件在参数区之前就结束了，或没有说明参数区的位置。</translation>
    </message>
    <message>
        <source>The file ends before its data begin.</source>
        <translation>文件在数据开始之前就结束了。</translation>
    </message>
    <message>
        <source>The file names an unknown number format ({0}).</source>
        <translation>文件所用的数字格式未知 ({0})。</translation>
    </message>
    <message>
        <source>There are no samples to write.</source>
        <translation>没有可写入的采样。</translation>
    </message>
    <message>
        <source>Open another recording.</source>
        <translation>请打开其他记录。</translation>
    </message>
    <message>
        <source>A C3D file holds at most {0} markers and {1} events, not {2} and {3}.</source>
        <translation>C3D 文件最多容纳 {0} 个标记点和 {1} 个事件，而不是 {2} 和 {3} 个。</translation>
    </message>
    <message>
        <source>Save fewer of them.</source>
        <translation>请减少保存的数量。</translation>
    </message>
    <message>
        <source>A C3D file numbers its frames from 0 to {0}, not from {1} to {2}.</source>
        <translation>C3D 文件的帧号为 0 至 {0}，而不是 {1} 至 {2}。</translation>
    </message>
    <message>
        <source>Number the frames of the original from 1.</source>
        <translation>请将原文件的帧从 1 开始编号。</translation>
    </message>
    <message>
        <source>A C3D file cannot hold a frame rate of {0} Hz.</source>
        <translation>C3D 文件无法容纳 {0} Hz 的帧率。</translation>
    </message>
    <message>
        <source>Correct the frame rate of the original.</source>
        <translation>请更正原文件的帧率。</translation>
    </message>
    <message>
        <source>Marker {0} at frame {1}: {2} {3} does not fit into the numbers of a C3D file.</source>
        <translation>标记点 {0} 第 {1} 帧：{2} {3} 超出 C3D 文件的数字范围。</translation>
    </message>
    <message>
        <source>Delete this sample first.</source>
        <translation>请先删除此采样。</translation>
    </message>
    <message>
        <source>The original is not there any more; saving copies its bytes.</source>
        <translation>原文件已不存在；保存时需要复制其字节。</translation>
    </message>
    <message>
        <source>Put it back under this name, then save again.</source>
        <translation>请以此名称放回原文件，然后重新保存。</translation>
    </message>
    <message>
        <source>The file became shorter while it was read.</source>
        <translation>文件在读取过程中变短了。</translation>
    </message>
    <message>
        <source>The file was changed while it was read.</source>
        <translation>文件在读取过程中被更改了。</translation>
    </message>
    <message>
        <source>Open it again.</source>
        <translation>请重新打开。</translation>
    </message>
    <message>
        <source>All names and events together need {0} bytes, and a C3D file has room for {1}.</source>
        <translation>全部名称和事件共需 {0} 字节，而 C3D 文件只能容纳 {1} 字节。</translation>
    </message>
    <message>
        <source>Shorten the labels, or save fewer markers or events.</source>
        <translation>请缩短名称，或减少保存的标记点或事件。</translation>
    </message>
    <message>
        <source>A repair does not fit into the integers of this file, and its structure does not allow to convert them to floats.</source>
        <translation>有一处修复超出此文件的整数范围，而其结构不允许转换为浮点数。</translation>
    </message>
    <message>
        <source>The skeleton (.asf) that this motion belongs to is not beside it.</source>
        <translation>此运动所属的骨架文件 (.asf) 不在旁边。</translation>
    </message>
    <message>
        <source>Put it into the same folder, under the name of the motion or of its subject.</source>
        <translation>请将其放入同一文件夹，以运动或受试者的名称命名。</translation>
    </message>
    <message>
        <source>The file ends before its first frame.</source>
        <translation>文件在第一帧之前就结束了。</translation>
    </message>
    <message>
        <source>Frame {0} has the bone {1}, which the skeleton lacks.</source>
        <translation>第 {0} 帧有骨段 {1}，而骨架中没有。</translation>
    </message>
    <message>
        <source>Frame {0} has no {1} values of the bone {2}, as the skeleton wants.</source>
        <translation>第 {0} 帧中骨段 {2} 没有骨架所要求的 {1} 个值。</translation>
    </message>
    <message>
        <source>Frame {0} has two bones {1}.</source>
        <translation>第 {0} 帧有两个骨段 {1}。</translation>
    </message>
    <message>
        <source>Frame {0} does not have the bones of the first frame.</source>
        <translation>第 {0} 帧的骨段与第一帧不同。</translation>
    </message>
    <message>
        <source>This is no AMC motion.</source>
        <translation>这不是 AMC 运动文件。</translation>
    </message>
    <message>
        <source>The skeleton file is too long.</source>
        <translation>骨架文件太长。</translation>
    </message>
    <message>
        <source>This is no ASF skeleton.</source>
        <translation>这不是 ASF 骨架文件。</translation>
    </message>
    <message>
        <source>The hierarchy does not join {0} to the root.</source>
        <translation>层级结构没有把 {0} 连接到根。</translation>
    </message>
    <message>
        <source>The skeleton has unknown degrees of freedom of {0}.</source>
        <translation>骨架中 {0} 的自由度未知。</translation>
    </message>
    <message>
        <source>{0} has the unknown order of axes {1}.</source>
        <translation>{0} 的轴顺序 {1} 未知。</translation>
    </message>
    <message>
        <source>{0} has no usable {1}.</source>
        <translation>{0} 没有可用的 {1}。</translation>
    </message>
    <message>
        <source>Bone {0}</source>
        <translation>骨段 {0}</translation>
    </message>
    <message>
        <source>The skeleton</source>
        <translation>骨架</translation>
    </message>
    <message>
        <source>The root</source>
        <translation>根</translation>
    </message>
    <message>
        <source>The hierarchy has the unknown bone {0}.</source>
        <translation>层级结构中有未知的骨段 {0}。</translation>
    </message>
    <message>
        <source>The hierarchy has two parents of {0}.</source>
        <translation>层级结构中 {0} 有两个父级。</translation>
    </message>
    <message>
        <source>The skeleton file ends within a bone.</source>
        <translation>骨架文件在骨段中间结束了。</translation>
    </message>
    <message>
        <source>The skeleton has a bone without a name.</source>
        <translation>骨架中有一个没有名称的骨段。</translation>
    </message>
    <message>
        <source>The skeleton has two bones {0}.</source>
        <translation>骨架中有两个骨段 {0}。</translation>
    </message>
    <message>
        <source>The skeleton has more than {0} bones.</source>
        <translation>骨架的骨段多于 {0} 个。</translation>
    </message>
    <message>
        <source>The file holds no marker.</source>
        <translation>文件中没有标记点。</translation>
    </message>
    <message>
        <source>The file holds no frames: there is nothing to repair.</source>
        <translation>文件中没有帧：没有可修复的内容。</translation>
    </message>
    <message>
        <source>This is not a BVH file.</source>
        <translation>这不是 BVH 文件。</translation>
    </message>
    <message>
        <source>The file ends before its motion.</source>
        <translation>文件在运动数据之前就结束了。</translation>
    </message>
    <message>
        <source>The hierarchy is too long.</source>
        <translation>层级结构太长。</translation>
    </message>
    <message>
        <source>Frame {0} does not consist of {1} numbers.</source>
        <translation>第 {0} 帧不是由 {1} 个数字组成。</translation>
    </message>
    <message>
        <source>The hierarchy ends before joint {0} is closed.</source>
        <translation>层级结构在关节 {0} 闭合之前就结束了。</translation>
    </message>
    <message>
        <source>The hierarchy has no joints.</source>
        <translation>层级结构中没有关节。</translation>
    </message>
    <message>
        <source>The hierarchy ends within the name of a joint.</source>
        <translation>层级结构在关节名称中间结束了。</translation>
    </message>
    <message>
        <source>The hierarchy has a name that is too long.</source>
        <translation>层级结构中有过长的名称。</translation>
    </message>
    <message>
        <source>The hierarchy has more than {0} joints.</source>
        <translation>层级结构的关节多于 {0} 个。</translation>
    </message>
    <message>
        <source>The offset of joint {0} is no three numbers.</source>
        <translation>关节 {0} 的偏移不是三个数字。</translation>
    </message>
    <message>
        <source>Joint {0} does not say how many channels it has.</source>
        <translation>关节 {0} 没有说明有多少个通道。</translation>
    </message>
    <message>
        <source>The hierarchy lacks an opening brace.</source>
        <translation>层级结构缺少左大括号。</translation>
    </message>
    <message>
        <source>The hierarchy has an End Site outside of its joints.</source>
        <translation>层级结构在关节之外有 End Site。</translation>
    </message>
    <message>
        <source>Joint {0} has the unknown channel {1}.</source>
        <translation>关节 {0} 有未知的通道 {1}。</translation>
    </message>
    <message>
        <source>The hierarchy has {0} outside of its joints.</source>
        <translation>层级结构在关节之外有 {0}。</translation>
    </message>
    <message>
        <source>The hierarchy has the unknown word {0}.</source>
        <translation>层级结构中有未知的词 {0}。</translation>
    </message>
    <message>
        <source>Line {0} has “{1}” where a number belongs.</source>
        <translation>第 {0} 行应为数字处是“{1}”。</translation>
    </message>
    <message>
        <source>A quotation mark is not closed between line {0} and line {1}.</source>
        <translation>第 {0} 行与第 {1} 行之间有未闭合的引号。</translation>
    </message>
    <message>
        <source>The file names {0} markers; at most {1} can be read.</source>
        <translation>文件列出 {0} 个标记点；最多能读取 {1} 个。</translation>
    </message>
    <message>
        <source>Name them as in frame, time, LASI_x, LASI_y, LASI_z or, with a line for each sample, frame, time, marker, x, y, z.</source>
        <translation>请按 frame, time, LASI_x, LASI_y, LASI_z 命名；若每个采样一行，则按 frame, time, marker, x, y, z。</translation>
    </message>
    <message>
        <source>The file has no row that names columns of markers.</source>
        <translation>文件中没有给标记点各列命名的行。</translation>
    </message>
    <message>
        <source>Line {0} has {1} numbers, but the first line has {2}.</source>
        <translation>第 {0} 行有 {1} 个数字，而第一行有 {2} 个。</translation>
    </message>
    <message>
        <source>A recording of UI-PRMD&apos;s Kinect is two files, and the other one is not there: {0}.</source>
        <translation>UI-PRMD 的 Kinect 记录由两个文件组成，而另一个文件不存在：{0}。</translation>
    </message>
    <message>
        <source>A recording of UI-PRMD&apos;s Kinect is two files, and the name of this one does not say which is the other.</source>
        <translation>UI-PRMD 的 Kinect 记录由两个文件组成，而从此文件的名称看不出另一个是哪个。</translation>
    </message>
    <message>
        <source>By its name this is the other file of a recording of UI-PRMD&apos;s Kinect, but it holds something else.</source>
        <translation>按名称这是 UI-PRMD 的 Kinect 记录的另一个文件，但其内容是别的东西。</translation>
    </message>
    <message>
        <source>Put the two files into the same folder, or into the folders Positions and Angles, under names as m01_s01_e01_positions.txt and m01_s01_e01_angles.txt.</source>
        <translation>请将两个文件放入同一文件夹，或分别放入 Positions 和 Angles 文件夹，名称如 m01_s01_e01_positions.txt 和 m01_s01_e01_angles.txt。</translation>
    </message>
    <message>
        <source>Some lines name neither a frame nor a time.</source>
        <translation>有些行既没有帧号也没有时间。</translation>
    </message>
    <message>
        <source>{0} lines are too few for {1} markers in {2} frames.</source>
        <translation>对 {2} 帧中的 {1} 个标记点而言，{0} 行太少。</translation>
    </message>
    <message>
        <source>There are no markers to export.</source>
        <translation>没有可导出的标记点。</translation>
    </message>
    <message>
        <source>The written file does not hold what it should; it was deleted.</source>
        <translation>写出的文件内容有误；已将其删除。</translation>
    </message>
    <message>
        <source>Try another disk.</source>
        <translation>请换一个磁盘。</translation>
    </message>
    <message>
        <source>{0} frames of {1} joints are too many for a file of this size.</source>
        <translation>对这样大小的文件而言，{1} 个关节的 {0} 帧太多。</translation>
    </message>
    <message>
        <source>Export it from Motive with its markers and with the header.</source>
        <translation>请从 Motive 导出，并包含标记点和文件头。</translation>
    </message>
    <message>
        <source>The file holds no markers.</source>
        <translation>文件中没有标记点。</translation>
    </message>
    <message>
        <source>The file holds no markers, only the poses of {0}.</source>
        <translation>文件中没有标记点，只有 {0} 的位姿。</translation>
    </message>
    <message>
        <source>The file has no rows that name its columns.</source>
        <translation>文件中没有给各列命名的行。</translation>
    </message>
    <message>
        <source>Export it from Nexus with its trajectories.</source>
        <translation>请从 Nexus 导出，并包含轨迹。</translation>
    </message>
    <message>
        <source>The file holds no trajectories.</source>
        <translation>文件中没有轨迹。</translation>
    </message>
    <message>
        <source>The file holds no trajectories, only {0}.</source>
        <translation>文件中没有轨迹，只有 {0}。</translation>
    </message>
    <message>
        <source>The trajectories have no row of X, Y and Z.</source>
        <translation>轨迹没有 X、Y、Z 行。</translation>
    </message>
    <message>
        <source>The file ends in the header of its trajectories.</source>
        <translation>文件在轨迹的表头中就结束了。</translation>
    </message>
    <message>
        <source>Save pos (frames, markers, 3), fps, names, units and up with numpy.savez.</source>
        <translation>请用 numpy.savez 保存 pos (frames, markers, 3)、fps、names、units 和 up。</translation>
    </message>
    <message>
        <source>The file has no array “pos”.</source>
        <translation>文件中没有数组“pos”。</translation>
    </message>
    <message>
        <source>“pos” must hold numbers, (frames, markers, 3), not {0} {1}.</source>
        <translation>“pos”必须是形状为 (frames, markers, 3) 的数字，而不是 {0} {1}。</translation>
    </message>
    <message>
        <source>The file has {0} markers; at most {1} can be read.</source>
        <translation>文件有 {0} 个标记点；最多能读取 {1} 个。</translation>
    </message>
    <message>
        <source>“names” must hold one text for each of the {0} markers, not {1} {2}.</source>
        <translation>“names”必须为 {0} 个标记点各含一个文本，而不是 {1} {2}。</translation>
    </message>
    <message>
        <source>Export the 3D data again from Qualisys Track Manager, with the TSV header.</source>
        <translation>请从 Qualisys Track Manager 重新导出三维数据，并包含 TSV 文件头。</translation>
    </message>
    <message>
        <source>The file holds no 3D markers.</source>
        <translation>文件中没有三维标记点。</translation>
    </message>
    <message>
        <source>The file holds no 3D markers but {0} data.</source>
        <translation>文件中没有三维标记点，只有 {0} 数据。</translation>
    </message>
    <message>
        <source>Line {0} or one before it is too long for a text file.</source>
        <translation>第 {0} 行或之前的某一行对文本文件而言太长。</translation>
    </message>
    <message>
        <source>This is not a text file.</source>
        <translation>这不是文本文件。</translation>
    </message>
    <message>
        <source>This is not a TRC file: it has no line that begins with “Frame#”.</source>
        <translation>这不是 TRC 文件：没有以“Frame#”开头的行。</translation>
    </message>
    <message>
        <source>Choose another file, or export it again from the program that made it.</source>
        <translation>请换一个文件，或从生成它的程序重新导出。</translation>
    </message>
    <message>
        <source>The file cannot be read: {0}.</source>
        <translation>无法读取文件：{0}。</translation>
    </message>
    <message>
        <source>Try a copy of it.</source>
        <translation>请试试它的副本。</translation>
    </message>
    <message>
        <source>The original was changed since it was opened.</source>
        <translation>原文件在打开之后被更改了。</translation>
    </message>
    <message>
        <source>Put the former file back under this name to save the repairs, or open it again.</source>
        <translation>要保存修复，请以此名称放回先前的文件，或重新打开。</translation>
    </message>
    <message>
        <source>The recording does not fit into memory.</source>
        <translation>内存容纳不下此记录。</translation>
    </message>
    <message>
        <source>Close other programs.</source>
        <translation>请关闭其他程序。</translation>
    </message>
    <message>
        <source>This is not an ordinary file.</source>
        <translation>这不是普通文件。</translation>
    </message>
    <message>
        <source>There is no such file.</source>
        <translation>没有这个文件。</translation>
    </message>
    <message>
        <source>Check the name and the folder.</source>
        <translation>请检查名称和文件夹。</translation>
    </message>
    <message>
        <source>This is a folder, not a file.</source>
        <translation>这是文件夹，不是文件。</translation>
    </message>
    <message>
        <source>Choose a file in it.</source>
        <translation>请选择其中的文件。</translation>
    </message>
    <message>
        <source>You may not read this file.</source>
        <translation>您没有读取此文件的权限。</translation>
    </message>
    <message>
        <source>Change its permissions or copy it.</source>
        <translation>请更改其权限或复制它。</translation>
    </message>
    <message>
        <source>The file is truncated: {0} of {1} frames are there.</source>
        <translation>文件被截断：{1} 帧中只有 {0} 帧。</translation>
    </message>
    <message>
        <source>Confirm that you want to save it all the same (--accept-truncated).</source>
        <translation>请确认仍要保存 (--accept-truncated)。</translation>
    </message>
    <message>
        <source>This is the file that the data come from.</source>
        <translation>这就是数据所来自的文件。</translation>
    </message>
    <message>
        <source>The c3d library does not confirm the saved file: {0}.</source>
        <translation>c3d 库未能确认所保存的文件：{0}。</translation>
    </message>
    <message>
        <source>Do not use the file, and report this.</source>
        <translation>请不要使用该文件，并报告此问题。</translation>
    </message>
    <message>
        <source>The recording has no markers to write.</source>
        <translation>记录中没有可写入的标记点。</translation>
    </message>
    <message>
        <source>Files that end in {0} cannot be written.</source>
        <translation>无法写入以 {0} 结尾的文件。</translation>
    </message>
    <message>
        <source>Choose a name that ends in one of {0}.</source>
        <translation>请选择以下列之一结尾的名称：{0}。</translation>
    </message>
    <message>
        <source>The saved edits cannot be discarded: {0}.</source>
        <translation>无法丢弃已保存的编辑：{0}。</translation>
    </message>
    <message>
        <source>The saved edits are damaged, or of another version of the program.</source>
        <translation>已保存的编辑已损坏，或来自程序的其他版本。</translation>
    </message>
    <message>
        <source>Try the version that made them.</source>
        <translation>请用生成它们的版本试试。</translation>
    </message>
    <message>
        <source>The saved edits cannot be read: {0}.</source>
        <translation>无法读取已保存的编辑：{0}。</translation>
    </message>
    <message>
        <source>The journal cannot be written: {0}. Edits since {1} are not protected against a crash.</source>
        <translation>无法写入编辑日志：{0}。{1} 之后的编辑在程序崩溃时得不到保护。</translation>
    </message>
    <message>
        <source>Export them soon.</source>
        <translation>请尽快导出。</translation>
    </message>
    <message>
        <source>Another window has recovered or discarded these edits.</source>
        <translation>另一个窗口已恢复或丢弃了这些编辑。</translation>
    </message>
    <message>
        <source>The recording was changed since these edits were made.</source>
        <translation>记录在这些编辑之后被更改了。</translation>
    </message>
    <message>
        <source>Put the former file back and open it; the edits are kept until you discard them.</source>
        <translation>请放回先前的文件并打开；编辑会一直保留，直到您丢弃。</translation>
    </message>
    <message>
        <source>A report is an HTML or a PDF file, and this name says neither.</source>
        <translation>报告是 HTML 或 PDF 文件，而此名称两者都不是。</translation>
    </message>
    <message>
        <source>End the name in .html or .pdf.</source>
        <translation>名称请以 .html 或 .pdf 结尾。</translation>
    </message>
    <message>
        <source>Choose other recordings, or name the markers to learn.</source>
        <translation>请选择其他记录，或指定要学习的标记点。</translation>
    </message>
    <message>
        <source>The written file is wrong and was removed: {0}</source>
        <translation>写出的文件有误，已将其删除：{0}</translation>
    </message>
    <message>
        <source>Please report this.</source>
        <translation>请报告此问题。</translation>
    </message>
    <message>
        <source>Too many jobs are running at once.</source>
        <translation>同时运行的任务太多。</translation>
    </message>
    <message>
        <source>Wait for one to end.</source>
        <translation>请等待其中一个结束。</translation>
    </message>
    <message>
        <source>The background worker stopped unexpectedly.</source>
        <translation>后台进程意外停止。</translation>
    </message>
    <message>
        <source>Retry.</source>
        <translation>请重试。</translation>
    </message>
    <message>
        <source>This is not a plan: {0}.</source>
        <translation>这不是计划：{0}。</translation>
    </message>
    <message>
        <source>Choose a file that was saved as a plan.</source>
        <translation>请选择保存为计划的文件。</translation>
    </message>
    <message>
        <source>it has no method with parameters</source>
        <translation>其中没有带参数的方法</translation>
    </message>
    <message>
        <source>its {0} is not a number from 0 upwards</source>
        <translation>其 {0} 不是大于等于 0 的数</translation>
    </message>
    <message>
        <source>The recipe does not fit this file: {0}.</source>
        <translation>修复方案不适用于此文件：{0}。</translation>
    </message>
    <message>
        <source>Use it with the file that it was made for.</source>
        <translation>请用于制作它时的文件。</translation>
    </message>
    <message>
        <source>This is not a recipe: {0}.</source>
        <translation>这不是修复方案：{0}。</translation>
    </message>
    <message>
        <source>Choose a file that was saved as a recipe.</source>
        <translation>请选择保存为修复方案的文件。</translation>
    </message>
    <message>
        <source>it has two edits of one gap</source>
        <translation>其中对同一缺失段有两项编辑</translation>
    </message>
    <message>
        <source>it has no list of edits</source>
        <translation>其中没有编辑列表</translation>
    </message>
    <message>
        <source>it asks for something that is no edit of a gap</source>
        <translation>其中有不属于缺失段编辑的操作</translation>
    </message>
    <message>
        <source>its point {0} is not the marker {1}</source>
        <translation>其中的点 {0} 不是标记点 {1}</translation>
    </message>
    <message>
        <source>frames {0} to {1} of {2} are not one of its gaps</source>
        <translation>{2} 的第 {0} 至 {1} 帧不是其缺失段之一</translation>
    </message>
    <message>
        <source>frames {0} to {1} of {2} are never to be filled</source>
        <translation>{2} 的第 {0} 至 {1} 帧永不填补</translation>
    </message>
    <message>
        <source>A gap of {0} cannot be filled: {1}.</source>
        <translation>{0} 的一个缺失段无法填补：{1}。</translation>
    </message>
    <message>
        <source>The recipe cannot be replayed: {0}.</source>
        <translation>无法重放修复方案：{0}。</translation>
    </message>
    <message>
        <source>Use the version of the program that the recipe names.</source>
        <translation>请使用修复方案中注明的程序版本。</translation>
    </message>
    <message>
        <source>The recipe was made for another recording, or by another version.</source>
        <translation>修复方案是为另一个记录或由其他版本制作的。</translation>
    </message>
    <message>
        <source>The name of the training set is too long to be written down with the repairs.</source>
        <translation>训练集的名称太长，无法随修复一起记录。</translation>
    </message>
    <message>
        <source>Move it to a folder with a shorter name.</source>
        <translation>请将其移到名称较短的文件夹。</translation>
    </message>
    <message>
        <source>The recipe needs a training set that is not there.</source>
        <translation>修复方案所需的训练集不存在。</translation>
    </message>
    <message>
        <source>Put the file in this place; a relative one is looked for in the current folder.</source>
        <translation>请将文件放到此处；相对路径在当前文件夹中查找。</translation>
    </message>
    <message>
        <source>This is not the training set that the recipe was made with.</source>
        <translation>这不是制作修复方案时所用的训练集。</translation>
    </message>
    <message>
        <source>Put the former file back in its place.</source>
        <translation>请将先前的文件放回原处。</translation>
    </message>
    <message>
        <source>The last of the saved edits were damaged and are lost.</source>
        <translation>最后保存的编辑已损坏并丢失。</translation>
    </message>
    <message>
        <source>All before them are recovered.</source>
        <translation>在其之前的编辑均已恢复。</translation>
    </message>
    <message>
        <source>The recording of these edits is not there any more.</source>
        <translation>这些编辑所属的记录已不存在。</translation>
    </message>
    <message>
        <source>Put it back, or open it where it is now: the edits are offered again then.</source>
        <translation>请将其放回，或在现在的位置打开：届时会再次提供恢复。</translation>
    </message>
    <message>
        <source>The file has no array “{0}”.</source>
        <translation>文件中没有数组“{0}”。</translation>
    </message>
    <message>
        <source>The array “{0}” is encrypted or compressed in an unknown way.</source>
        <translation>数组“{0}”已加密，或以未知方式压缩。</translation>
    </message>
    <message>
        <source>The array “{0}” would grow from {1} to {2} bytes; that is not believable.</source>
        <translation>数组“{0}”展开后会从 {1} 增至 {2} 字节；这不可信。</translation>
    </message>
    <message>
        <source>This is not an .npz file, or it is damaged.</source>
        <translation>这不是 .npz 文件，或者已损坏。</translation>
    </message>
    <message>
        <source>The array “{0}” is damaged.</source>
        <translation>数组“{0}”已损坏。</translation>
    </message>
    <message>
        <source>“{0}” is no array.</source>
        <translation>“{0}”不是数组。</translation>
    </message>
    <message>
        <source>“{0}” is no array of numbers or text.</source>
        <translation>“{0}”不是数字或文本的数组。</translation>
    </message>
    <message>
        <source>The size of “{0}” is not what its header says.</source>
        <translation>“{0}”的大小与其头部所述不符。</translation>
    </message>
    <message>
        <source>This is not a template of labels.</source>
        <translation>这不是标签模板。</translation>
    </message>
    <message>
        <source>Choose a file that “mocapmend label --save-template” has written.</source>
        <translation>请选择由“mocapmend label --save-template”写出的文件。</translation>
    </message>
    <message>
        <source>the marker is hidden throughout</source>
        <translation>标记点全程被遮挡</translation>
    </message>
    <message>
        <source>the marker fell off</source>
        <translation>标记点脱落</translation>
    </message>
    <message>
        <source>the marker has moved on the body</source>
        <translation>标记点在身体上移位</translation>
    </message>
    <message>
        <source>it is too long to trust a repair</source>
        <translation>缺失过长，修复结果不可信</translation>
    </message>
    <message>
        <source>too few markers around it are seen</source>
        <translation>周围可见的标记点太少</translation>
    </message>
    <message>
        <source>it is not needed for the analysis</source>
        <translation>分析中不需要</translation>
    </message>
    <message>
        <source>fill {0} gaps ({1})</source>
        <translation>填补 {0} 个缺失段 ({1})</translation>
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
        <source>leave a gap of {0} open</source>
        <translation>保留 {0} 的一个缺失段不填补</translation>
    </message>
    <message>
        <source>take up a gap of {0} again</source>
        <translation>恢复 {0} 的一个缺失段</translation>
    </message>
    <message>
        <source>say why a gap of {0} stays open</source>
        <translation>说明 {0} 的一个缺失段为何不填补</translation>
    </message>
    <message>
        <source>say why {0} gaps stay open</source>
        <translation>说明 {0} 个缺失段为何不填补</translation>
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
        <source>move the ends of a gap of {0}</source>
        <translation>移动 {0} 缺失段的两端</translation>
    </message>
    <message>
        <source>replay {0}</source>
        <translation>重放 {0}</translation>
    </message>
    <message>
        <source>left open by hand</source>
        <translation>手动保留未填补</translation>
    </message>
    <message>
        <source>it is marked as never to be filled</source>
        <translation>已标记为永不填补</translation>
    </message>
    <message>
        <source>the preview was cancelled</source>
        <translation>预览已取消</translation>
    </message>
    <message>
        <source>the preview failed</source>
        <translation>预览失败</translation>
    </message>
    <message>
        <source>the expected error of {0} is above the limit of {1}</source>
        <translation>预期误差 {0} 超过限值 {1}</translation>
    </message>
    <message>
        <source>the expected error of {0} is above the default limit of {1}</source>
        <translation>预期误差 {0} 超过默认限值 {1}</translation>
    </message>
    <message>
        <source>its error could not be estimated: there is nothing like it to test this method on</source>
        <translation>无法估计其误差：没有类似的片段可用来测试此方法</translation>
    </message>
    <message>
        <source>its error could not be estimated, and {0} is longer than the {1} allowed in that case</source>
        <translation>无法估计其误差，且 {0} 超过此情况下允许的 {1}</translation>
    </message>
    <message>
        <source>{0} is longer than the limit of {1}</source>
        <translation>{0} 超过限值 {1}</translation>
    </message>
    <message>
        <source>{0} is longer than the default limit of {1}</source>
        <translation>{0} 超过默认限值 {1}</translation>
    </message>
    <message>
        <source>1 frame ({0} ms)</source>
        <translation>1 帧 ({0} ms)</translation>
    </message>
    <message>
        <source>{0} frames ({1} ms)</source>
        <translation>{0} 帧 ({1} ms)</translation>
    </message>
    <message>
        <source>the marker is never seen in this recording</source>
        <translation>该标记点在此记录中从未出现</translation>
    </message>
    <message>
        <source>the marker is never seen after frame {0}: this method needs both sides</source>
        <translation>第 {0} 帧之后该标记点再未出现：此方法需要两侧的采样</translation>
    </message>
    <message>
        <source>the marker is never seen before frame {0}: this method needs both sides</source>
        <translation>第 {0} 帧之前该标记点从未出现：此方法需要两侧的采样</translation>
    </message>
    <message>
        <source>a constant needs {0} samples, and the marker has only {1}</source>
        <translation>常值需要 {0} 个采样，而该标记点只有 {1} 个</translation>
    </message>
    <message>
        <source>a straight line needs {0} samples, and the marker has only {1}</source>
        <translation>直线需要 {0} 个采样，而该标记点只有 {1} 个</translation>
    </message>
    <message>
        <source>a cubic curve needs {0} samples, and the marker has only {1}</source>
        <translation>三次曲线需要 {0} 个采样，而该标记点只有 {1} 个</translation>
    </message>
    <message>
        <source>a curve needs {0} samples, and the marker has only {1}</source>
        <translation>曲线需要 {0} 个采样，而该标记点只有 {1} 个</translation>
    </message>
    <message>
        <source>a quintic curve needs {0} samples, and the marker has only {1}</source>
        <translation>五次曲线需要 {0} 个采样，而该标记点只有 {1} 个</translation>
    </message>
    <message>
        <source>the filter needs {0} samples, and the marker has only {1}</source>
        <translation>滤波器需要 {0} 个采样，而该标记点只有 {1} 个</translation>
    </message>
    <message>
        <source>the filter needs {0} samples before the gap, and the marker has only {1}</source>
        <translation>滤波器需要缺失段之前有 {0} 个采样，而该标记点只有 {1} 个</translation>
    </message>
    <message>
        <source>the motion is not periodic: it does not repeat itself closely enough</source>
        <translation>运动没有周期性：重复得不够接近</translation>
    </message>
    <message>
        <source>no other cycle of {0} s has this marker in all frames that are missing here</source>
        <translation>在其他长 {0} s 的周期中，没有一个在此处缺失的各帧里都有该标记点</translation>
    </message>
    <message>
        <source>the gap lies at the beginning of the recording, and such gaps are to be left open</source>
        <translation>缺失段位于记录开头，按设定不填补</translation>
    </message>
    <message>
        <source>the gap lies at the end of the recording, and such gaps are to be left open</source>
        <translation>缺失段位于记录结尾，按设定不填补</translation>
    </message>
    <message>
        <source>it is at the start or the end of the recording, where gaps are to be left open</source>
        <translation>它位于记录的开头或结尾，按设定不填补</translation>
    </message>
    <message>
        <source>it is at the beginning or the end, and no other marker is seen throughout</source>
        <translation>它位于开头或结尾，且没有其他标记点全程可见</translation>
    </message>
    <message>
        <source>only {0} frames show the marker and those that predict it: this method needs {1}</source>
        <translation>只有 {0} 帧同时有该标记点和用来预测它的标记点：此方法需要 {1} 帧</translation>
    </message>
    <message>
        <source>only {0} frames show the marker and those that predict it: this method needs {1} in a row</source>
        <translation>只有 {0} 帧同时有该标记点和用来预测它的标记点：此方法需要连续 {1} 帧</translation>
    </message>
    <message>
        <source>of the other markers, {0} have no gap at all: this method needs {1}</source>
        <translation>其他标记点中有 {0} 个完全没有缺失段：此方法需要 {1} 个</translation>
    </message>
    <message>
        <source>of the other markers, {0} are seen throughout the gap: this method needs {1}</source>
        <translation>其他标记点中有 {0} 个在缺失段内全程可见：此方法需要 {1} 个</translation>
    </message>
    <message>
        <source>fewer than {0} other markers that are seen often enough are there in most of the gap: this method has too little to tell the posture by</source>
        <translation>在缺失段的大部分时间里，出现得足够多的其他标记点少于 {0} 个：此方法没有足够的依据来推断姿势</translation>
    </message>
    <message>
        <source>fewer than {0} other markers that are seen often enough are there: this method has too little to tell the posture by</source>
        <translation>出现得足够多的其他标记点少于 {0} 个：此方法没有足够的依据来推断姿势</translation>
    </message>
    <message>
        <source>fewer than {0} other markers that are seen often enough are there in some of the gap: this method has too little to tell the pose by</source>
        <translation>在缺失段的部分时间里，出现得足够多的其他标记点少于 {0} 个：此方法没有足够的依据来推断姿态</translation>
    </message>
    <message>
        <source>this method needs {0} stretches that show the marker and those that predict it, and has {1}</source>
        <translation>此方法需要 {0} 个同时有该标记点和用来预测它的标记点的片段，而只有 {1} 个</translation>
    </message>
    <message>
        <source>it takes {0} donors and was given {1}</source>
        <translation>需要 {0} 个参考标记点，而只给出 {1} 个</translation>
    </message>
    <message>
        <source>the recording is too short for the windows of this method</source>
        <translation>对此方法的窗口而言，记录太短</translation>
    </message>
    <message>
        <source>there is no marker {0} to take as a donor</source>
        <translation>没有可作参考标记点的标记点 {0}</translation>
    </message>
    <message>
        <source>{0} markers are called {1}: it cannot be a donor</source>
        <translation>有 {0} 个标记点名为 {1}：它不能作参考标记点</translation>
    </message>
    <message>
        <source>{0} cannot be its own donor</source>
        <translation>{0} 不能作自己的参考标记点</translation>
    </message>
    <message>
        <source>the donor {0} is missing in the gap too</source>
        <translation>参考标记点 {0} 在缺失段内也缺失</translation>
    </message>
    <message>
        <source>the donor {0} is missing at an edge of the gap</source>
        <translation>参考标记点 {0} 在缺失段一端缺失</translation>
    </message>
    <message>
        <source>no marker is seen throughout the gap and at its edges, and it takes {0}</source>
        <translation>没有标记点在缺失段内及其两端全程可见，而此方法需要 {0} 个</translation>
    </message>
    <message>
        <source>only {0} of the markers are seen throughout the gap and at its edges, and it takes {1}</source>
        <translation>只有 {0} 个标记点在缺失段内及其两端全程可见，而此方法需要 {1} 个</translation>
    </message>
    <message>
        <source>the marker and its donor {0} are hardly ever seen together</source>
        <translation>该标记点与其参考标记点 {0} 几乎从未同时可见</translation>
    </message>
    <message>
        <source>the marker and its donors are hardly ever seen together</source>
        <translation>该标记点与其参考标记点几乎从未同时可见</translation>
    </message>
    <message>
        <source>the training set does not have this marker</source>
        <translation>训练集中没有此标记点</translation>
    </message>
    <message>
        <source>the training set has no such marker</source>
        <translation>训练集中没有这样的标记点</translation>
    </message>
    <message>
        <source>no marker of the training set is seen all through the gap</source>
        <translation>训练集的标记点中没有一个在缺失段内全程可见</translation>
    </message>
    <message>
        <source>Trained dictionaries come with a training set, and none is given.</source>
        <translation>训练好的字典随训练集提供，而没有指定训练集。</translation>
    </message>
    <message>
        <source>The dictionaries were trained at {0} Hz, and this recording has {1}.</source>
        <translation>字典是以 {0} Hz 训练的，而此记录为 {1} Hz。</translation>
    </message>
    <message>
        <source>The training set is of other markers: {0} of its {1} are not in this recording ({2}).</source>
        <translation>训练集使用的是其他标记点：其 {1} 个中有 {0} 个不在此记录中 ({2})。</translation>
    </message>
    <message>
        <source>The recording has more than one marker {0}: a training set is for one subject.</source>
        <translation>记录中有不止一个标记点 {0}：训练集只适用于一名受试者。</translation>
    </message>
    <message>
        <source>This is not a file.</source>
        <translation>这不是文件。</translation>
    </message>
    <message>
        <source>There is no such training set.</source>
        <translation>没有这个训练集。</translation>
    </message>
    <message>
        <source>This training set may not be read.</source>
        <translation>没有读取此训练集的权限。</translation>
    </message>
    <message>
        <source>This is not a training set of mocapmend, or it is damaged.</source>
        <translation>这不是 mocapmend 的训练集，或者已损坏。</translation>
    </message>
    <message>
        <source>The training set would grow beyond what is believable.</source>
        <translation>训练集展开后的大小不可信。</translation>
    </message>
    <message>
        <source>The head of the training set is too long.</source>
        <translation>训练集的头部太长。</translation>
    </message>
    <message>
        <source>The training set has {0} in “{1}”, not float32.</source>
        <translation>训练集的“{1}”中是 {0}，而不是 float32。</translation>
    </message>
    <message>
        <source>The training set has format {0}, not {1}.</source>
        <translation>训练集的格式是 {0}，而不是 {1}。</translation>
    </message>
    <message>
        <source>The training set says that {0} points up.</source>
        <translation>训练集称 {0} 轴朝上。</translation>
    </message>
    <message>
        <source>The training set contradicts itself: its frames are not as listed.</source>
        <translation>训练集自相矛盾：其中的帧与所列不符。</translation>
    </message>
    <message>
        <source>The training set has a dictionary that is no table.</source>
        <translation>训练集中有一个字典不是表。</translation>
    </message>
    <message>
        <source>The training set has values that are no numbers.</source>
        <translation>训练集中有不是数字的值。</translation>
    </message>
    <message>
        <source>The training set has no trained dictionaries of all parts.</source>
        <translation>训练集没有全部部位的训练字典。</translation>
    </message>
    <message>
        <source>Choose a file that “mocapmend train sparse” has written.</source>
        <translation>请选择由“mocapmend train sparse”写出的文件。</translation>
    </message>
    <message>
        <source>Choose a file that “mocapmend train sparse” has written, or one that ships with the program: {0}.</source>
        <translation>请选择由“mocapmend train sparse”写出的文件，或随程序提供的文件：{0}。</translation>
    </message>
    <message>
        <source>The file&apos;s repair record cannot be used: {0}.</source>
        <translation>无法使用文件的修复记录：{0}。</translation>
    </message>
    <message>
        <source>{0} samples at (0, 0, 0), which means missing in a C3D file, were moved by {1} {2}.</source>
        <translation>{0} 个位于 (0, 0, 0) 的采样（在 C3D 文件中表示缺失）被移动了 {1} {2}。</translation>
    </message>
    <message>
        <source>The file says that it has {0} force plates and describes {1}.</source>
        <translation>文件称有 {0} 个测力台，却描述了 {1} 个。</translation>
    </message>
    <message>
        <source>Force plates {0}: {1}.</source>
        <translation>测力台 {0}：{1}。</translation>
    </message>
    <message>
        <source>Force plate {0}: {1}.</source>
        <translation>测力台 {0}：{1}。</translation>
    </message>
    <message>
        <source>the type is not known</source>
        <translation>类型未知</translation>
    </message>
    <message>
        <source>type {0} is not known</source>
        <translation>类型 {0} 未知</translation>
    </message>
    <message>
        <source>not all analog channels are in the file</source>
        <translation>文件中没有其全部模拟通道</translation>
    </message>
    <message>
        <source>{0} analog channels do not belong to type {1}</source>
        <translation>{0} 个模拟通道与类型 {1} 不符</translation>
    </message>
    <message>
        <source>type {0} needs a calibration matrix, and there is none</source>
        <translation>类型 {0} 需要标定矩阵，而文件中没有</translation>
    </message>
    <message>
        <source>type {0} has no use for the calibration matrix</source>
        <translation>类型 {0} 用不到标定矩阵</translation>
    </message>
    <message>
        <source>the corners span no surface</source>
        <translation>四角不构成平面</translation>
    </message>
    <message>
        <source>The {0} analog values of a frame cannot be split into channels; they are taken for one sample of each.</source>
        <translation>每帧的 {0} 个模拟值无法分配到各通道；按每通道一个采样处理。</translation>
    </message>
    <message>
        <source>The file states no usable scale; floats in its own unit are assumed.</source>
        <translation>文件没有给出可用的比例；假定为以其自身单位表示的浮点数。</translation>
    </message>
    <message>
        <source>The header&apos;s scale ({0}) and POINT:SCALE ({1}) differ; {2} is used.</source>
        <translation>文件头的比例 ({0}) 与 POINT:SCALE ({1}) 不同；采用 {2}。</translation>
    </message>
    <message>
        <source>The file states no frame rate; {0} Hz is assumed.</source>
        <translation>文件没有给出帧率；假定为 {0} Hz。</translation>
    </message>
    <message>
        <source>The header&apos;s frame rate ({0} Hz) and POINT:RATE ({1} Hz) differ; {2} Hz is used.</source>
        <translation>文件头的帧率 ({0} Hz) 与 POINT:RATE ({1} Hz) 不同；采用 {2} Hz。</translation>
    </message>
    <message>
        <source>TRIAL:ACTUAL_START_FIELD says that the first frame is {0}; the header&apos;s {1} is used.</source>
        <translation>TRIAL:ACTUAL_START_FIELD 称首帧为 {0}；采用文件头的 {1}。</translation>
    </message>
    <message>
        <source>The header&apos;s first frame ({0}) and TRIAL:ACTUAL_START_FIELD ({1}) differ; {2} is used.</source>
        <translation>文件头的首帧 ({0}) 与 TRIAL:ACTUAL_START_FIELD ({1}) 不同；采用 {2}。</translation>
    </message>
    <message>
        <source>Header and parameters disagree on the numbers of points and analog values per frame; {0} and {1} are used.</source>
        <translation>文件头与参数所述的每帧点数和模拟值数不一致；采用 {0} 和 {1}。</translation>
    </message>
    <message>
        <source>The file states different numbers of frames ({0}); {1} is used.</source>
        <translation>文件给出的帧数不一致 ({0})；采用 {1}。</translation>
    </message>
    <message>
        <source>The file does not say where its data begin; they are taken to follow the parameters.</source>
        <translation>文件没有说明数据从何处开始；假定紧接在参数之后。</translation>
    </message>
    <message>
        <source>Parameters occur more than once, and the first is used: {0}.</source>
        <translation>有重复的参数，采用第一个：{0}。</translation>
    </message>
    <message>
        <source>The header puts the data at block {0} and POINT:DATA_START at block {1}; {2} is used.</source>
        <translation>文件头称数据在第 {0} 块，POINT:DATA_START 称在第 {1} 块；采用 {2}。</translation>
    </message>
    <message>
        <source>Names that a C3D file cannot hold were cut ({0}); the first is {1}.</source>
        <translation>C3D 文件容纳不下的名称已被截短 ({0})；第一个是 {1}。</translation>
    </message>
    <message>
        <source>The file holds no marker data: there is nothing to repair.</source>
        <translation>文件中没有标记点数据：没有可修复的内容。</translation>
    </message>
    <message>
        <source>{0} bytes follow the last frame; they are kept as they are.</source>
        <translation>最后一帧之后还有 {0} 个字节；原样保留。</translation>
    </message>
    <message>
        <source>{0} samples are exactly (0, 0, 0) or not finite without a mark of missing; they are taken as missing.</source>
        <translation>{0} 个采样恰为 (0, 0, 0) 或不是有限数，却没有缺失标记；按缺失处理。</translation>
    </message>
    <message>
        <source>The file says that {0} points up, which would put the markers below the floor; {1} is used.</source>
        <translation>文件称 {0} 朝上，这会使标记点位于地面以下；采用 {1}。</translation>
    </message>
    <message>
        <source>A skeleton file holds no motion; the rest pose is shown as one frame. Open the .amc file to see a motion.</source>
        <translation>骨架文件不含运动；静止姿势显示为一帧。要查看运动，请打开 .amc 文件。</translation>
    </message>
    <message>
        <source>The file states no rate and no axis that points up; {0} Hz and +y, as in CMU&apos;s recordings, are assumed.</source>
        <translation>文件没有给出帧率和朝上的轴；假定与 CMU 的记录相同，为 {0} Hz 和 +y。</translation>
    </message>
    <message>
        <source>One length unit of the skeleton is taken for 1/{0} inch, as in CMU&apos;s recordings, and lengths are converted to cm.</source>
        <translation>骨架的一个长度单位按 CMU 的记录取为 1/{0} 英寸，长度换算为 cm。</translation>
    </message>
    <message>
        <source>The skeleton is {0}, the only one in the folder.</source>
        <translation>骨架为 {0}，即文件夹中唯一的一个。</translation>
    </message>
    <message>
        <source>{0} bones have no values in the motion and do not turn.</source>
        <translation>{0} 个骨段在运动中没有数值，不转动。</translation>
    </message>
    <message>
        <source>The last frame is incomplete and is left out.</source>
        <translation>最后一帧不完整，已略去。</translation>
    </message>
    <message>
        <source>Frame {0} does not follow the frame before it; frames are read as if none were left out.</source>
        <translation>第 {0} 帧与前一帧不连续；按没有遗漏的帧读取。</translation>
    </message>
    <message>
        <source>Bones that shift or stretch are drawn with a fixed length.</source>
        <translation>会移动或伸缩的骨段按固定长度绘制。</translation>
    </message>
    <message>
        <source>The numbers of the frames do not count up by one; the lines are taken as consecutive frames.</source>
        <translation>帧号不是逐一递增；各行按连续的帧处理。</translation>
    </message>
    <message>
        <source>Some frames have no number; the lines are taken as consecutive frames.</source>
        <translation>有些帧没有编号；各行按连续的帧处理。</translation>
    </message>
    <message>
        <source>Frames that the file leaves out are taken as frames without markers: {0}.</source>
        <translation>文件略去的帧按没有标记点的帧处理：{0}。</translation>
    </message>
    <message>
        <source>The file states no frame rate; its times say {0} Hz.</source>
        <translation>文件没有给出帧率；其时间表明为 {0} Hz。</translation>
    </message>
    <message>
        <source>The file states {0} Hz, but its times say {1} Hz; {2} Hz is used.</source>
        <translation>文件给出 {0} Hz，而其时间表明为 {1} Hz；采用 {2} Hz。</translation>
    </message>
    <message>
        <source>The file states no length unit; {0} is assumed from the size of the skeleton.</source>
        <translation>文件没有给出长度单位；根据骨架大小假定为 {0}。</translation>
    </message>
    <message>
        <source>The file does not say which axis points up; {0} is assumed.</source>
        <translation>文件没有说明哪个轴朝上；假定为 {0}。</translation>
    </message>
    <message>
        <source>The frame time {0} s may be a rounded 1/{1} s; {2} Hz is used.</source>
        <translation>帧时间 {0} s 可能由 1/{1} s 舍入而来；采用 {2} Hz。</translation>
    </message>
    <message>
        <source>The file states no length unit; 1/0.45 inch, as in CMU&apos;s recordings, is assumed from the size of the skeleton, and lengths are converted to cm.</source>
        <translation>文件没有给出长度单位；根据骨架大小假定与 CMU 的记录相同，为 1/0.45 英寸，长度换算为 cm。</translation>
    </message>
    <message>
        <source>The file states no usable frame time; {0} Hz is assumed.</source>
        <translation>文件没有给出可用的帧时间；假定为 {0} Hz。</translation>
    </message>
    <message>
        <source>The file holds no motion; the rest pose is shown as one frame.</source>
        <translation>文件不含运动；静止姿势显示为一帧。</translation>
    </message>
    <message>
        <source>The file does not say how many frames it holds.</source>
        <translation>文件没有说明含有多少帧。</translation>
    </message>
    <message>
        <source>The file says that it holds {0} frames, but {1} are there; all are read.</source>
        <translation>文件称含有 {0} 帧，实有 {1} 帧；已全部读取。</translation>
    </message>
    <message>
        <source>The last line is no complete frame and is left out.</source>
        <translation>最后一行不是完整的帧，已略去。</translation>
    </message>
    <message>
        <source>Most lines after line {0} end before their last column.</source>
        <translation>第 {0} 行之后的大多数行在最后一列之前就结束了。</translation>
    </message>
    <message>
        <source>The last line is cut off; it is left out.</source>
        <translation>最后一行被截断；已略去。</translation>
    </message>
    <message>
        <source>Labels that were empty or had characters that no file holds are changed: {0}.</source>
        <translation>空的或含有文件无法容纳的字符的名称已更改：{0}。</translation>
    </message>
    <message>
        <source>TRC files know mm, cm and m; the coordinates are written in mm, not {0}.</source>
        <translation>TRC 文件只支持 mm、cm 和 m；坐标以 mm 而不是 {0} 写入。</translation>
    </message>
    <message>
        <source>Samples exactly at (0, 0, 0) would be missing to a reader; their x is written as {0}: {1}.</source>
        <translation>恰在 (0, 0, 0) 的采样会被读取程序视为缺失；其 x 写为 {0}：{1}。</translation>
    </message>
    <message>
        <source>Samples exactly at (0, 0, 0) are taken as missing: {0}.</source>
        <translation>恰在 (0, 0, 0) 的采样按缺失处理：{0}。</translation>
    </message>
    <message>
        <source>Samples without some of their coordinates are taken as missing: {0}.</source>
        <translation>缺少部分坐标的采样按缺失处理：{0}。</translation>
    </message>
    <message>
        <source>Samples impossibly far away are taken as missing: {0}.</source>
        <translation>距离远得不可能的采样按缺失处理：{0}。</translation>
    </message>
    <message>
        <source>{0} samples depend on values that are no numbers or far too large; they are taken as missing.</source>
        <translation>{0} 个采样取决于不是数字或过大的值；按缺失处理。</translation>
    </message>
    <message>
        <source>1 joint has the label of another joint.</source>
        <translation>1 个关节与另一个关节同名。</translation>
    </message>
    <message>
        <source>{0} joints have the label of another joint.</source>
        <translation>{0} 个关节与其他关节同名。</translation>
    </message>
    <message>
        <source>1 point has the label of another point.</source>
        <translation>1 个点与另一个点同名。</translation>
    </message>
    <message>
        <source>{0} points have the label of another point.</source>
        <translation>{0} 个点与其他点同名。</translation>
    </message>
    <message>
        <source>Markers that are not measured, but where Motive expects them on a body or bone: {0} of {1}.</source>
        <translation>不是测得、而是 Motive 在刚体或骨骼上推定的标记点：{1} 个中有 {0} 个。</translation>
    </message>
    <message>
        <source>The poses of bodies and bones are left out: {0}.</source>
        <translation>刚体和骨骼的位姿已略去：{0}。</translation>
    </message>
    <message>
        <source>Other sections of the file are left out: {0}.</source>
        <translation>文件的其他部分已略去：{0}。</translation>
    </message>
    <message>
        <source>The orientations of the joints are left out.</source>
        <translation>关节的朝向已略去。</translation>
    </message>
    <message>
        <source>Samples that the Kinect did not track are taken as missing: {0}.</source>
        <translation>Kinect 未跟踪到的采样按缺失处理：{0}。</translation>
    </message>
    <message>
        <source>Samples that the Kinect did not see but inferred are kept as they are: {0} of {1}.</source>
        <translation>Kinect 未看到而是推断出的采样保持原样：{1} 个中的 {0} 个。</translation>
    </message>
    <message>
        <source>Samples whose state of tracking is unknown are kept as they are: {0}.</source>
        <translation>跟踪状态未知的采样保持原样：{0}。</translation>
    </message>
    <message>
        <source>The times in {0} cannot be used.</source>
        <translation>{0} 中的时间无法使用。</translation>
    </message>
    <message>
        <source>The times in {0} say {1} Hz.</source>
        <translation>由 {0} 中的时间得出 {1} Hz。</translation>
    </message>
    <message>
        <source>{0} has {1} times for {2} frames; only the frame rate is taken from it.</source>
        <translation>{0} 有 {1} 个时间，而帧数为 {2}；只从中取帧率。</translation>
    </message>
    <message>
        <source>{0} of {1} steps from frame to frame are more than a quarter longer or shorter than {2} ms; the frames are taken as evenly spaced.</source>
        <translation>{1} 个帧间隔中有 {0} 个比 {2} ms 长或短四分之一以上；各帧按等间隔处理。</translation>
    </message>
    <message>
        <source>There are {0} frames of positions and {1} of angles; the first {2} are read.</source>
        <translation>位置有 {0} 帧，角度有 {1} 帧；读取前 {2} 帧。</translation>
    </message>
    <message>
        <source>The file does not name its markers; Plug-in Gait&apos;s names are assumed.</source>
        <translation>文件没有给出标记点名称；假定为 Plug-in Gait 的名称。</translation>
    </message>
    <message>
        <source>The bones of the file do not fit its markers; they are ignored.</source>
        <translation>文件中的骨段与其标记点不符；已忽略。</translation>
    </message>
    <message>
        <source>The parents of the markers do not fit the markers; they are ignored.</source>
        <translation>标记点的父级与标记点不符；已忽略。</translation>
    </message>
    <message>
        <source>There are {0} markers by the header, but it names {1}.</source>
        <translation>文件头称有 {0} 个标记点，却列出 {1} 个名称。</translation>
    </message>
    <message>
        <source>Markers without a label in the file: {0}.</source>
        <translation>文件中没有名称的标记点：{0}。</translation>
    </message>
    <message>
        <source>There are {0} markers by the header, but {1} in the file.</source>
        <translation>文件头称有 {0} 个标记点，而文件中有 {1} 个。</translation>
    </message>
    <message>
        <source>There are {0} frames by the header, but {1} in the file.</source>
        <translation>文件头称有 {0} 帧，而文件中有 {1} 帧。</translation>
    </message>
    <message>
        <source>The file names {0} of its {1} points; the others are called by their number.</source>
        <translation>文件的 {1} 个点中有 {0} 个有名称；其余以编号称呼。</translation>
    </message>
    <message>
        <source>{0} of {1} repairs of the repair record are not in the file any more; their samples are taken as they are.</source>
        <translation>修复记录的 {1} 处修复中有 {0} 处已不在文件中；其采样按现状采用。</translation>
    </message>
    <message>
        <source>{0} of {1} gaps that the repair record keeps open are not in the file any more.</source>
        <translation>修复记录规定不填补的 {1} 个缺失段中有 {0} 个已不在文件中。</translation>
    </message>
    <message>
        <source>The repair record {0} belongs to another state of this file; its repairs are taken for measured samples.</source>
        <translation>修复记录 {0} 属于此文件的另一状态；其中的修复按测得的采样处理。</translation>
    </message>
    <message>
        <source>The repair record {0} cannot be read: {1}.</source>
        <translation>无法读取修复记录 {0}：{1}。</translation>
    </message>
    <message>
        <source>The repair record {0} cannot be used: {1}.</source>
        <translation>无法使用修复记录 {0}：{1}。</translation>
    </message>
    <message>
        <source>The file is truncated: it says that it holds {0} frames, but only {1} are there.</source>
        <translation>文件被截断：文件称含有 {0} 帧，但只有 {1} 帧。</translation>
    </message>
    <message>
        <source>The file states no length unit; {0} is assumed from the size of its numbers.</source>
        <translation>文件没有给出长度单位；根据数值大小假定为 {0}。</translation>
    </message>
    <message>
        <source>The file states an unknown length unit ({0}); {1} is assumed from the size of its numbers.</source>
        <translation>文件给出的长度单位未知 ({0})；根据数值大小假定为 {1}。</translation>
    </message>
    <message>
        <source>The file does not say which axis points up; {0} is a guess.</source>
        <translation>文件没有说明哪个轴朝上；{0} 是推测。</translation>
    </message>
    <message>
        <source>The new file has the markers alone, without {0}.</source>
        <translation>新文件只有标记点，没有{0}。</translation>
    </message>
    <message>
        <source>analog data</source>
        <translation>模拟数据</translation>
    </message>
    <message>
        <source>model outputs</source>
        <translation>模型输出</translation>
    </message>
    <message>
        <source>events</source>
        <translation>事件</translation>
    </message>
    <message>
        <source>residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>bones</source>
        <translation>骨段</translation>
    </message>
    <message>
        <source>the axis that points up</source>
        <translation>朝上的轴</translation>
    </message>
    <message>
        <source>The skeleton template {0} is left out: {1}.</source>
        <translation>骨架模板 {0} 已略去：{1}。</translation>
    </message>
    <message>
        <source>it is larger than 1 MB</source>
        <translation>它大于 1 MB</translation>
    </message>
    <message>
        <source>it is not UTF-8 text</source>
        <translation>它不是 UTF-8 文本</translation>
    </message>
    <message>
        <source>it is nested too deeply</source>
        <translation>它的嵌套太深</translation>
    </message>
    <message>
        <source>it is not TOML: {0}</source>
        <translation>它不是 TOML：{0}</translation>
    </message>
    <message>
        <source>it has format {0}, and this version reads {1}</source>
        <translation>其格式为 {0}，而此版本读取 {1}</translation>
    </message>
    <message>
        <source>it is not written in JSON</source>
        <translation>它不是以 JSON 写成的</translation>
    </message>
    <message>
        <source>it is not a JSON document</source>
        <translation>它不是 JSON 文档</translation>
    </message>
    <message>
        <source>it is not of format {0}, which this version reads</source>
        <translation>它不是此版本所读取的格式 {0}</translation>
    </message>
    <message>
        <source>it has no list of repairs</source>
        <translation>它没有修复列表</translation>
    </message>
    <message>
        <source>it has no list of gaps kept open</source>
        <translation>它没有不填补的缺失段的列表</translation>
    </message>
    <message>
        <source>it has no {0}</source>
        <translation>它没有 {0}</translation>
    </message>
    <message>
        <source>it is too large</source>
        <translation>它太大</translation>
    </message>
    <message>
        <source>it does not say which file it belongs to</source>
        <translation>它没有说明属于哪个文件</translation>
    </message>
    <message>
        <source>it does not say which file was repaired</source>
        <translation>它没有说明修复的是哪个文件</translation>
    </message>
    <message>
        <source>a repair is not an object</source>
        <translation>有一处修复不是对象</translation>
    </message>
    <message>
        <source>{0} of a repair is missing or of another kind</source>
        <translation>修补记录中的 {0} 缺失或类型不符</translation>
    </message>
    <message>
        <source>a number or a text of a repair is too large</source>
        <translation>修复中有过大的数字或文本</translation>
    </message>
    <message>
        <source>a gap kept open is not an object</source>
        <translation>有一个不填补的缺失段不是对象</translation>
    </message>
    <message>
        <source>{0} of a gap kept open is missing or of another kind</source>
        <translation>不填补的缺失段的 {0} 缺失或类型不符</translation>
    </message>
    <message>
        <source>a number or a text of a gap kept open is too large</source>
        <translation>不填补的缺失段中有过大的数字或文本</translation>
    </message>
    <message>
        <source>a donor is not a label</source>
        <translation>有一个参考标记点不是名称</translation>
    </message>
    <message>
        <source>a parameter is neither a number nor a text, nor a list of texts</source>
        <translation>有一个参数既不是数字或文本，也不是文本列表</translation>
    </message>
    <message>
        <source>fix {0} ({1})</source>
        <translation>修正 {0} ({1})</translation>
    </message>
    <message>
        <source>fix {0} problems ({1})</source>
        <translation>修正 {0} 个问题 ({1})</translation>
    </message>
    <message>
        <source>fix {0} problems</source>
        <translation>修正 {0} 个问题</translation>
    </message>
    <message>
        <source>set {0} samples of {1} aside</source>
        <translation>搁置 {1} 的 {0} 个采样</translation>
    </message>
    <message>
        <source>believe {0} samples of {1} again</source>
        <translation>重新采用 {1} 的 {0} 个采样</translation>
    </message>
    <message>
        <source>exchange {0}</source>
        <translation>互换 {0}</translation>
    </message>
    <message>
        <source>correct as in {0}</source>
        <translation>按 {0} 修正</translation>
    </message>
    <message>
        <source>fill {0} gaps again</source>
        <translation>重新填补 {0} 个缺失段</translation>
    </message>
    <message>
        <source>{0} markers</source>
        <translation>{0} 个标记点</translation>
    </message>
    <message>
        <source>It was set aside by hand.</source>
        <translation>手动搁置。</translation>
    </message>
    <message>
        <source>It belongs to none of the labels.</source>
        <translation>它不属于任何名称。</translation>
    </message>
    <message>
        <source>1 frame</source>
        <translation>1 帧</translation>
    </message>
    <message>
        <source>{0} frames</source>
        <translation>{0} 帧</translation>
    </message>
    <message>
        <source>For {0} it is {1} mm from where the frames before and after lead, {2} times the noise there.</source>
        <translation>有 {0} 偏离前后帧所指的位置 {1} mm，为该处噪声的 {2} 倍。</translation>
    </message>
    <message>
        <source>For 1 frame {0} and {1}, {2} mm apart, each continue the other&apos;s trajectory.</source>
        <translation>有 1 帧，{0} 与 {1}（相距 {2} mm）各自延续了对方的轨迹。</translation>
    </message>
    <message>
        <source>For {0} frames {1} and {2}, {3} mm apart, each continue the other&apos;s trajectory.</source>
        <translation>有 {0} 帧，{1} 与 {2}（相距 {3} mm）各自延续了对方的轨迹。</translation>
    </message>
    <message>
        <source>For {0} its distances to its neighbours differ by {1} mm from what they are otherwise.</source>
        <translation>有 {0} 与相邻标记点的距离同平时相差 {1} mm。</translation>
    </message>
    <message>
        <source>For {0} it is {1} mm from the middle of the body, where it is {2} mm otherwise.</source>
        <translation>有 {0} 距身体中心 {1} mm，平时为 {2} mm。</translation>
    </message>
    <message>
        <source>For {0} it is in the same place as {1}, from which it is {2} mm away otherwise.</source>
        <translation>有 {0} 与 {1} 处于同一位置，平时相距 {2} mm。</translation>
    </message>
    <message>
        <source>The sample after a gap bends away from the trajectory, by up to {0} mm.</source>
        <translation>缺失段之后的采样偏离轨迹，最多 {0} mm。</translation>
    </message>
    <message>
        <source>The sample before a gap bends away from the trajectory, by up to {0} mm.</source>
        <translation>缺失段之前的采样偏离轨迹，最多 {0} mm。</translation>
    </message>
    <message>
        <source>The {0} samples after a gap bend away from the trajectory, by up to {1} mm.</source>
        <translation>缺失段之后的 {0} 个采样偏离轨迹，最多 {1} mm。</translation>
    </message>
    <message>
        <source>The {0} samples before a gap bend away from the trajectory, by up to {1} mm.</source>
        <translation>缺失段之前的 {0} 个采样偏离轨迹，最多 {1} mm。</translation>
    </message>
    <message>
        <source>It jumps {0} mm, and then the same coordinates are repeated {1} times.</source>
        <translation>它跳动 {0} mm，然后相同的坐标重复 {1} 次。</translation>
    </message>
    <message>
        <source>The same coordinates are repeated {0}, and then it is {1} mm away.</source>
        <translation>相同的坐标重复{0}，然后相距 {1} mm。</translation>
    </message>
    <message>
        <source>The same coordinates are repeated {0}, while it has moved by {1} mm.</source>
        <translation>相同的坐标重复{0}，而其间移动了 {1} mm。</translation>
    </message>
    <message>
        <source>once</source>
        <translation>一次</translation>
    </message>
    <message>
        <source>{0} times</source>
        <translation>{0} 次</translation>
    </message>
    <message>
        <source>It is seen for {0} and {1}.</source>
        <translation>可见 {0}，{1}。</translation>
    </message>
    <message>
        <source>no marker is missing there that it could be</source>
        <translation>那里没有它可能属于的缺失标记点</translation>
    </message>
    <message>
        <source>fits no marker: {0} comes nearest, off by {1} times the usual</source>
        <translation>不属于任何标记点：最接近的是 {0}，偏差为平时的 {1} 倍</translation>
    </message>
    <message>
        <source>may be {0} or {1}: it fits both about as well</source>
        <translation>可能是 {0} 或 {1}：两者同样吻合</translation>
    </message>
    <message>
        <source>For {0} it fits into a gap of {1}: it is off by {2} times what is usual, no other is missing.</source>
        <translation>有 {0} 符合 {1} 的缺失段：偏差为平时的 {2} 倍，没有其他标记点缺失。</translation>
    </message>
    <message>
        <source>For {0} it fits into a gap of {1}: it is off by {2} times what is usual, the next marker by {3}.</source>
        <translation>有 {0} 符合 {1} 的缺失段：偏差为平时的 {2} 倍，其次的标记点为 {3} 倍。</translation>
    </message>
    <message>
        <source>{0} measured sample were set aside, or are no longer; the repair record lists them.</source>
        <translation>{0} 个测量采样被搁置或不再搁置；修复记录中已列出。</translation>
    </message>
    <message>
        <source>{0} measured samples were set aside, or are no longer; the repair record lists them.</source>
        <translation>{0} 个测量采样被搁置或不再搁置；修复记录中已列出。</translation>
    </message>
    <message>
        <source>{0} measured sample were smoothed; the repair record lists them.</source>
        <translation>{0} 个测量采样被平滑；修复记录中已列出。</translation>
    </message>
    <message>
        <source>{0} measured samples were smoothed; the repair record lists them.</source>
        <translation>{0} 个测量采样被平滑；修复记录中已列出。</translation>
    </message>
    <message>
        <source>{0} sample changed places between markers; the repair record lists them.</source>
        <translation>{0} 个采样在标记点之间互换；修复记录中已列出。</translation>
    </message>
    <message>
        <source>{0} samples changed places between markers; the repair record lists them.</source>
        <translation>{0} 个采样在标记点之间互换；修复记录中已列出。</translation>
    </message>
    <message>
        <source>{0} is called {1}; the repair record lists it.</source>
        <translation>{0} 改名为 {1}；修复记录中已列出。</translation>
    </message>
    <message>
        <source>{0} is called {1} and {2} more; the repair record lists it.</source>
        <translation>{0} 改名为 {1}，另有 {2} 个；修复记录中已列出。</translation>
    </message>
    <message>
        <source>Marker {0}: {1} set aside were not measured as the repair record says, the first at frame {2}.</source>
        <translation>标记点 {0}：被搁置的 {1} 与修复记录所述的测量值不符，首个在第 {2} 帧。</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 个采样</translation>
    </message>
    <message>
        <source>{0} samples</source>
        <translation>{0} 个采样</translation>
    </message>
    <message>
        <source>The repair record lists exchanges that contradict each other.</source>
        <translation>修复记录所列的互换相互矛盾。</translation>
    </message>
    <message>
        <source>{0} of {1} runs that the repair record sets aside are not in the file any more; their samples are taken as they are.</source>
        <translation>修复记录搁置的 {1} 个连续段中有 {0} 个已不在文件中；其采样按现状采用。</translation>
    </message>
    <message>
        <source>{0} of {1} exchanged runs of the repair record are not in the file any more; their samples are taken as they are.</source>
        <translation>修复记录的 {1} 处互换中有 {0} 处已不在文件中；其采样按现状采用。</translation>
    </message>
    <message>
        <source>{0} of {1} smoothed runs of the repair record are not in the file any more; their samples are taken as they are.</source>
        <translation>修复记录的 {1} 处平滑中有 {0} 处已不在文件中；其采样按现状采用。</translation>
    </message>
    <message>
        <source>{0} of {1} new names of the repair record are not in the file any more.</source>
        <translation>修复记录的 {1} 个新名称中有 {0} 个已不在文件中。</translation>
    </message>
    <message>
        <source>The parameters of this file have no room for the label {0}.</source>
        <translation>此文件的参数中容不下名称 {0}。</translation>
    </message>
    <message>
        <source>Choose shorter labels, or save it as another format.</source>
        <translation>请选用更短的名称，或另存为其他格式。</translation>
    </message>
    <message>
        <source>This cannot be smoothed: {0}.</source>
        <translation>无法平滑：{0}。</translation>
    </message>
    <message>
        <source>Choose other parameters, or another method.</source>
        <translation>请选择其他参数，或其他方法。</translation>
    </message>
    <message>
        <source>No labels can be learned: {0}.</source>
        <translation>无法学习名称：{0}。</translation>
    </message>
    <message>
        <source>Choose recordings whose markers are labelled.</source>
        <translation>请选择标记点有名称的记录。</translation>
    </message>
    <message>
        <source>smooth {0} markers ({1})</source>
        <translation>平滑 {0} 个标记点 ({1})</translation>
    </message>
    <message>
        <source>smooth {0} ({1})</source>
        <translation>平滑 {0} ({1})</translation>
    </message>
    <message>
        <source>take smoothing off {0} markers</source>
        <translation>取消 {0} 个标记点的平滑</translation>
    </message>
    <message>
        <source>take smoothing off {0}</source>
        <translation>取消 {0} 的平滑</translation>
    </message>
    <message>
        <source>replay the smoothing of {0}</source>
        <translation>重放 {0} 的平滑</translation>
    </message>
    <message>
        <source>There are no samples.</source>
        <translation>没有采样。</translation>
    </message>
    <message>
        <source>Only {0} on end: this needs at least {1}.</source>
        <translation>连续的只有 {0}：至少需要 {1} 个。</translation>
    </message>
    <message>
        <source>order must be an even number from 2, not {0}</source>
        <translation>阶数须为不小于 2 的偶数，而不是 {0}</translation>
    </message>
    <message>
        <source>cutoff_hz must be above 0 and below half the frame rate, {0} Hz, not {1}</source>
        <translation>截止频率须大于 0 且低于帧率的一半 {0} Hz，而不是 {1}</translation>
    </message>
    <message>
        <source>cutoff_hz must be from {0} Hz to below half the frame rate, {1} Hz, not {2}</source>
        <translation>截止频率须不低于 {0} Hz 且低于帧率的一半 {1} Hz，而不是 {2}</translation>
    </message>
    <message>
        <source>give cutoff_hz or noise_mm, not both: each says how much to smooth</source>
        <translation>截止频率与测量噪声只能给出其一：二者都决定平滑程度</translation>
    </message>
    <message>
        <source>noise_mm must be above 0 mm, not {0}</source>
        <translation>测量噪声须大于 0 mm，而不是 {0}</translation>
    </message>
    <message>
        <source>order must be at least 1, not {0}</source>
        <translation>阶数至少为 1，而不是 {0}</translation>
    </message>
    <message>
        <source>window_ms must be at least {0} ms at {1} Hz: order {2} needs {3} frames, and {4} ms are {5}</source>
        <translation>窗口至少须为 {0} ms（{1} Hz 时）：{2} 阶需要 {3} 帧，而 {4} ms 只有 {5} 帧</translation>
    </message>
    <message>
        <source>rename {0} to {1}</source>
        <translation>将 {0} 重命名为 {1}</translation>
    </message>
    <message>
        <source>exchange the names of {0} and {1}</source>
        <translation>交换 {0} 与 {1} 的名称</translation>
    </message>
    <message>
        <source>label {0} pieces</source>
        <translation>标注 {0} 个片段</translation>
    </message>
    <message>
        <source>label {0} as {1}, frames {2} to {3}</source>
        <translation>将 {0} 标注为 {1}，第 {2} 至 {3} 帧</translation>
    </message>
    <message>
        <source>It has this name already.</source>
        <translation>它已有此名称。</translation>
    </message>
    <message>
        <source>It has a name that the labelled recordings do not have, and is left alone.</source>
        <translation>它的名称在已标注的记录中没有，保持不变。</translation>
    </message>
    <message>
        <source>It is {0} mm from where the other markers put {1}; no other label fits nearly as well.</source>
        <translation>它距其他标记点推算的 {1} 位置 {0} mm；没有其他标签同样吻合。</translation>
    </message>
    <message>
        <source>It is {0} mm from where the other markers put {1}, but {2}.</source>
        <translation>它距其他标记点推算的 {1} 位置 {0} mm，但{2}。</translation>
    </message>
    <message>
        <source>Its distances to the other markers are those of {0}; no other label fits nearly as well.</source>
        <translation>它到其他标记点的距离与 {0} 一致；没有其他标签同样吻合。</translation>
    </message>
    <message>
        <source>Its distances to the other markers are those of {0}, but {1}.</source>
        <translation>它到其他标记点的距离与 {0} 一致，但{1}。</translation>
    </message>
    <message>
        <source>it may as well be no marker at all</source>
        <translation>它也可能根本不是标记点</translation>
    </message>
    <message>
        <source>{0} fits nearly as well</source>
        <translation>{0} 也几乎同样吻合</translation>
    </message>
    <message>
        <source>left and right can hardly be told apart: with {0} labels in each other&apos;s place, and {1} here, the body fits nearly as well</source>
        <translation>左右几乎无法区分：{0} 个标签互换位置、此处为 {1} 时，身体也几乎同样吻合</translation>
    </message>
    <message>
        <source>by the shape of the body that was learned, it may be {0} throughout</source>
        <translation>按学到的身体形状，它可能始终是 {0}</translation>
    </message>
    <message>
        <source>the other pieces with this label fit better</source>
        <translation>带此标签的其他片段更吻合</translation>
    </message>
    <message>
        <source>Too few points are seen at once to tell which labels they are.</source>
        <translation>同时可见的点太少，无法判断它们的标签。</translation>
    </message>
    <message>
        <source>It is where no label would be.</source>
        <translation>它所在的位置不属于任何标签。</translation>
    </message>
    <message>
        <source>It is most like {0}, but other points fit that better.</source>
        <translation>它最像 {0}，但其他点更吻合。</translation>
    </message>
    <message>
        <source>A marker needs a name.</source>
        <translation>标记点需要名称。</translation>
    </message>
    <message>
        <source>Type one.</source>
        <translation>请输入一个。</translation>
    </message>
    <message>
        <source>A name must not have line breaks or other control characters.</source>
        <translation>名称不能包含换行或其他控制字符。</translation>
    </message>
    <message>
        <source>This name is too long: it takes {0} bytes, and a C3D file has room for {1}.</source>
        <translation>此名称太长：它占 {0} 字节，而 C3D 文件只容纳 {1} 字节。</translation>
    </message>
    <message>
        <source>The marker is not seen in the selected frames.</source>
        <translation>该标记点在所选帧中不可见。</translation>
    </message>
    <message>
        <source>The marker is not seen in this frame: go to one in which it is.</source>
        <translation>该标记点在此帧不可见：请转到它可见的帧。</translation>
    </message>
    <message>
        <source>The marker has this label already.</source>
        <translation>该标记点已有此标签。</translation>
    </message>
    <message>
        <source>No point has this label, and this one has another.</source>
        <translation>没有点有此标签，而此点另有标签。</translation>
    </message>
    <message>
        <source>Rename the marker, or choose a label that a point has.</source>
        <translation>请重命名该标记点，或选择某个点已有的标签。</translation>
    </message>
    <message>
        <source>the recordings to learn from show {0} named markers; at least {1} are needed that are seen together</source>
        <translation>用于学习的记录有 {0} 个已命名的标记点；至少需要 {1} 个同时可见的</translation>
    </message>
    <message>
        <source>{0} of {1} points have no label. “Label from recordings…” in the Edit menu finds out which markers they are.</source>
        <translation>{1} 个点中有 {0} 个没有标签。“编辑”菜单中的“按已标注的记录标注…”可找出它们是哪些标记点。</translation>
    </message>
    <message>
        <source>Kinect, 22 joints, to Plug-in Gait, 39 markers</source>
        <translation>Kinect（22 个关节）到 Plug-in Gait（39 个标记点）</translation>
    </message>
    <message>
        <source>Kinect v2, 25 joints, to Axis Neuron, 59 joints</source>
        <translation>Kinect v2（25 个关节）到 Axis Neuron（59 个关节）</translation>
    </message>
    <message>
        <source>What a network computes is an estimate, not a measurement. It was trained on the people and movements that its card names; of other movements it knows nothing.</source>
        <translation>网络计算出的是估计值，不是测量值。它由其说明卡所列的人员和动作训练而成；对其他动作一无所知。</translation>
    </message>
    <message>
        <source>For a person whom it has not seen, expect no more than from smoothing and regression: see the figures for new people on its card, if there are some. Paired recordings of that person to calibrate with, one of each movement, take much of the error away.</source>
        <translation>对于它未见过的人，不要期望优于平滑加回归：如果有的话，请看其说明卡上关于新人的数据。用该人每个动作各一个成对记录进行校准，可消除大部分误差。</translation>
    </message>
    <message>
        <source>Measured on pairs held out ({0}):</source>
        <translation>在留出的成对记录上测得（{0} 对）：</translation>
    </message>
    <message>
        <source>Measured after the same training without some people ({0}; pairs: {1}):</source>
        <translation>同样训练但不含部分人时，在这些人上测得（{0}；{1} 对）：</translation>
    </message>
    <message>
        <source>All markers were computed from the joints of another recording; none was measured.</source>
        <translation>所有标记点均由另一记录的关节计算得出；没有一个是测得的。</translation>
    </message>
    <message>
        <source>All markers were computed by the network “{0}” from the joints of another recording; none was measured.</source>
        <translation>所有标记点均由网络“{0}”根据另一记录的关节计算得出；没有一个是测得的。</translation>
    </message>
    <message>
        <source>No reference recording was given: how far the markers are from where they really were is not known.</source>
        <translation>没有给出参考记录：标记点偏离真实位置多远是未知的。</translation>
    </message>
    <message>
        <source>Lp: mean square error of a coordinate relative to the pelvis or hips, after the best turn. Lb: of bone lengths, from their means in the reference. Ls: mean square second difference of a coordinate. All at 60 Hz.</source>
        <translation>Lp：经最佳旋转后，坐标相对骨盆或髋部的均方误差。Lb：骨段长度相对参考记录中平均值的均方误差。Ls：坐标二阶差分的均方值。均按 60 Hz 计算。</translation>
    </message>
    <message>
        <source>{0} pairs of recordings of {1} people and {2} movements, {3} frames at 60 Hz</source>
        <translation>{1} 人、{2} 种动作的 {0} 对记录，60 Hz 的 {3} 帧</translation>
    </message>
    <message>
        <source>{0} stacked bidirectional recurrent autoencoders of width {1}; {2} weights</source>
        <translation>{0} 个堆叠的双向循环自编码器，宽度 {1}；{2} 个权重</translation>
    </message>
    <message>
        <source>{0} stacked bidirectional recurrent autoencoders of width {1}, a linear skip; {2} weights</source>
        <translation>{0} 个堆叠的双向循环自编码器，宽度 {1}，带线性直连；{2} 个权重</translation>
    </message>
    <message>
        <source>{0} stacked bidirectional recurrent autoencoders of width {1}, a perceptual autoencoder; {2} weights</source>
        <translation>{0} 个堆叠的双向循环自编码器，宽度 {1}，带感知自编码器；{2} 个权重</translation>
    </message>
    <message>
        <source>{0} stacked bidirectional recurrent autoencoders of width {1}, a linear skip, a perceptual autoencoder; {2} weights</source>
        <translation>{0} 个堆叠的双向循环自编码器，宽度 {1}，带线性直连和感知自编码器；{2} 个权重</translation>
    </message>
    <message>
        <source>This recording has no markers to compare with.</source>
        <translation>此记录没有可供比较的标记点。</translation>
    </message>
    <message>
        <source>These joints are never seen: {0}.</source>
        <translation>这些关节从未被看到：{0}。</translation>
    </message>
    <message>
        <source>The network is for other points ({0}): {1} of {2} are not in this recording ({3}).</source>
        <translation>此网络使用的是其他点（{0}）：其 {2} 个中有 {1} 个不在此记录中（{3}）。</translation>
    </message>
    <message>
        <source>The recording has more than one {0}.</source>
        <translation>记录中有不止一个 {0}。</translation>
    </message>
    <message>
        <source>The recording has fewer than two frames.</source>
        <translation>记录少于两帧。</translation>
    </message>
    <message>
        <source>The reference has fewer than two frames.</source>
        <translation>参考记录少于两帧。</translation>
    </message>
    <message>
        <source>Recording and reference have less than half a second in common.</source>
        <translation>记录与参考记录的共同时间不足半秒。</translation>
    </message>
    <message>
        <source>The recording is too long: {0} s of at most {1} s.</source>
        <translation>记录过长：{0} 秒，最多 {1} 秒。</translation>
    </message>
    <message>
        <source>{0} is impossibly far from the root: more than {1} m.</source>
        <translation>{0} 离根节点远得不可能：超过 {1} 米。</translation>
    </message>
    <message>
        <source>Choose another network or recording.</source>
        <translation>请选择另一个网络或记录。</translation>
    </message>
    <message>
        <source>Put the recording right first, or choose another one.</source>
        <translation>请先修正该记录，或选择另一个。</translation>
    </message>
    <message>
        <source>Its joints are those of the profile {0}: train a network for it with “mocapmend train refine”, or choose one.</source>
        <translation>其关节属于配置 {0}：请用“mocapmend train refine”为它训练网络，或选择一个这样的网络。</translation>
    </message>
    <message>
        <source>Leave this calibration out.</source>
        <translation>请去掉这个校准。</translation>
    </message>
    <message>
        <source>A recording cannot calibrate itself.</source>
        <translation>记录不能用来校准自己。</translation>
    </message>
    <message>
        <source>Choose another recording of the same person.</source>
        <translation>请选择同一人的另一个记录。</translation>
    </message>
    <message>
        <source>Choose another reference.</source>
        <translation>请选择另一个参考记录。</translation>
    </message>
    <message>
        <source>These pairs are for the profile {0}.</source>
        <translation>这些成对数据用于配置 {0}。</translation>
    </message>
    <message>
        <source>Choose that one.</source>
        <translation>请选择该配置。</translation>
    </message>
    <message>
        <source>Choose another file.</source>
        <translation>请选择另一个文件。</translation>
    </message>
    <message>
        <source>There is no such model.</source>
        <translation>没有这个模型。</translation>
    </message>
    <message>
        <source>This model may not be read.</source>
        <translation>没有读取此模型的权限。</translation>
    </message>
    <message>
        <source>This is not a model of mocapmend, or it is damaged.</source>
        <translation>这不是 mocapmend 的模型，或者已损坏。</translation>
    </message>
    <message>
        <source>The model is too large.</source>
        <translation>模型太大。</translation>
    </message>
    <message>
        <source>The head of the model is too long.</source>
        <translation>模型的头部太长。</translation>
    </message>
    <message>
        <source>The model has format {0}, not {1}.</source>
        <translation>模型的格式是 {0}，而不是 {1}。</translation>
    </message>
    <message>
        <source>The model contradicts itself: its network is not for its profile.</source>
        <translation>模型自相矛盾：其网络与其配置不符。</translation>
    </message>
    <message>
        <source>The model contradicts itself: “{0}” is not as its head says.</source>
        <translation>模型自相矛盾：“{0}”与其头部所述不符。</translation>
    </message>
    <message>
        <source>The model has a spread that is not positive.</source>
        <translation>模型中有不为正的离散度。</translation>
    </message>
    <message>
        <source>The model&apos;s network is too large.</source>
        <translation>模型的网络太大。</translation>
    </message>
    <message>
        <source>The model has weights that are no numbers in “{0}”.</source>
        <translation>模型的“{0}”中有不是数字的权重。</translation>
    </message>
    <message>
        <source>Choose a file that “mocapmend train refine” has written, or one that ships with the program: {0}.</source>
        <translation>请选择由“mocapmend train refine”写出的文件，或随程序提供的：{0}。</translation>
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
        <source>Nothing fits. Fewer letters find more.</source>
        <translation>没有匹配项。少输入几个字可找到更多。</translation>
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
    <name>SmoothPane</name>
    <message>
        <source>Which markers</source>
        <translation>哪些标记点</translation>
    </message>
    <message>
        <source>Selected markers</source>
        <translation>所选标记点</translation>
    </message>
    <message>
        <source>All markers</source>
        <translation>全部标记点</translation>
    </message>
    <message>
        <source>Which frames</source>
        <translation>哪些帧</translation>
    </message>
    <message>
        <source>Whole recording</source>
        <translation>整个记录</translation>
    </message>
    <message>
        <source>Selected frames</source>
        <translation>所选帧</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>平滑</translation>
    </message>
    <message>
        <source>Take off</source>
        <translation>取消平滑</translation>
    </message>
    <message>
        <source>Smoothing method</source>
        <translation>平滑方法</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>In</source>
        <translation>范围</translation>
    </message>
    <message>
        <source>Frames {0} – {1}</source>
        <translation>第 {0} – {1} 帧</translation>
    </message>
    <message>
        <source>&lt;b&gt;{0} is smoothed&lt;/b&gt;</source>
        <translation>&lt;b&gt;{0} 已平滑&lt;/b&gt;</translation>
    </message>
    <message>
        <source>{0}, {1} Hz, moved by {2} mm RMS</source>
        <translation>{0}，{1} Hz，移动量均方根 {2} mm</translation>
    </message>
    <message>
        <source>and {0} more stretches</source>
        <translation>以及另外 {0} 个区段</translation>
    </message>
    <message>
        <source>Select a marker to see what smoothing would do to it.</source>
        <translation>选择一个标记点以查看平滑的效果。</translation>
    </message>
    <message>
        <source>Computing the preview…</source>
        <translation>正在计算预览…</translation>
    </message>
    <message>
        <source>Preview of the {0} markers selected last.</source>
        <translation>预览最后选择的 {0} 个标记点。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Next to nothing was found to smooth&lt;/b&gt; in {0}: the cut-off is close to half of the frame rate ({1} Hz).</source>
        <translation>{0} 中&lt;b&gt;几乎没有可平滑的内容&lt;/b&gt;：截止频率接近帧率的一半 ({1} Hz)。</translation>
    </message>
    <message>
        <source>If you see jitter all the same, give a cut-off.</source>
        <translation>若仍看到抖动，请指定截止频率。</translation>
    </message>
    <message>
        <source>If you see jitter all the same, give a window.</source>
        <translation>若仍看到抖动，请指定窗口。</translation>
    </message>
    <message>
        <source>If you see jitter all the same, give the measurement noise.</source>
        <translation>若仍看到抖动，请指定测量噪声。</translation>
    </message>
    <message>
        <source>Fewer than {0} samples on end.</source>
        <translation>连续采样不足 {0} 个。</translation>
    </message>
    <message>
        <source>Left as they are: stretches {0}. {1}</source>
        <translation>保持原样的区段：{0} 个。{1}</translation>
    </message>
</context>
<context>
    <name>SmoothTable</name>
    <message>
        <source>Marker</source>
        <translation>标记点</translation>
    </message>
    <message>
        <source>Cut-off (Hz)</source>
        <translation>截止 (Hz)</translation>
    </message>
    <message>
        <source>RMS mm</source>
        <translation>均方根 mm</translation>
    </message>
    <message>
        <source>Max mm</source>
        <translation>最大 mm</translation>
    </message>
    <message>
        <source>✔: smoothed in this way already</source>
        <translation>✔：已按此方式平滑</translation>
    </message>
    <message>
        <source>Of x, y and z: motion faster than this is taken for noise</source>
        <translation>x、y、z 各自的截止频率：比它更快的运动视为噪声</translation>
    </message>
    <message>
        <source>How far samples would be moved: root mean square</source>
        <translation>采样将移动的距离：均方根</translation>
    </message>
    <message>
        <source>The largest distance that a sample would be moved</source>
        <translation>单个采样将移动的最大距离</translation>
    </message>
    <message>
        <source>What smoothing would do</source>
        <translation>平滑的效果</translation>
    </message>
</context>
<context>
    <name>Smoothing</name>
    <message>
        <source>Preview</source>
        <translation>预览</translation>
    </message>
    <message>
        <source>Smoothing is still going on.</source>
        <translation>平滑仍在进行。</translation>
    </message>
    <message>
        <source>Nothing to smooth: select markers that are seen here.</source>
        <translation>没有可平滑的内容：请选择此处可见的标记点。</translation>
    </message>
    <message>
        <source>Smoothing {0} markers</source>
        <translation>正在平滑 {0} 个标记点</translation>
    </message>
    <message>
        <source>Smoothing taken off: stretches {0}.</source>
        <translation>已取消平滑的区段：{0} 个。</translation>
    </message>
    <message>
        <source>This file came smoothed: what was measured is in the original alone.</source>
        <translation>此文件打开时已平滑：测量值只在原始文件中。</translation>
    </message>
    <message>
        <source>There is no smoothing here.</source>
        <translation>此处没有平滑。</translation>
    </message>
    <message>
        <source>The recording was edited meanwhile: smooth again.</source>
        <translation>记录在此期间已被编辑：请重新平滑。</translation>
    </message>
    <message>
        <source>Nothing was smoothed: the stretches are too short.</source>
        <translation>没有平滑任何内容：区段太短。</translation>
    </message>
    <message>
        <source>Markers smoothed: {0}; samples moved by {1} mm RMS, {2} mm at most.</source>
        <translation>已平滑的标记点：{0} 个；采样移动量均方根 {1} mm，最大 {2} mm。</translation>
    </message>
    <message>
        <source>Stretches left as they were: {0}.</source>
        <translation>保持原样的区段：{0} 个。</translation>
    </message>
    <message>
        <source>Next to nothing was found to smooth in {0} of them.</source>
        <translation>其中 {0} 个几乎没有可平滑的内容。</translation>
    </message>
    <message>
        <source>Cancelled: nothing was smoothed.</source>
        <translation>已取消：没有平滑任何内容。</translation>
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
    <name>SuspectBox</name>
    <message>
        <source>Current problem</source>
        <translation>当前问题</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>修正</translation>
    </message>
    <message>
        <source>No problem</source>
        <translation>没有问题</translation>
    </message>
    <message>
        <source>Believe again</source>
        <translation>重新采用</translation>
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
        <source>Fix this kind</source>
        <translation>修正此类</translation>
    </message>
    <message>
        <source>Fix all</source>
        <translation>全部修正</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>Reject</source>
        <translation>拒绝</translation>
    </message>
    <message>
        <source>A problem after all</source>
        <translation>仍是问题</translation>
    </message>
    <message>
        <source>&lt;b&gt;Rejected:&lt;/b&gt; it stays as it is.</source>
        <translation>&lt;b&gt;已拒绝：&lt;/b&gt;保持原样。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Accepting&lt;/b&gt; says that it is no marker.</source>
        <translation>&lt;b&gt;接受&lt;/b&gt;即表示它不是标记点。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Accepting&lt;/b&gt; gives it the label {0} when the labels are applied.</source>
        <translation>&lt;b&gt;接受&lt;/b&gt;后，应用标签时它将得到标签 {0}。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Accepted:&lt;/b&gt; it gets the label {0} when the labels are applied.</source>
        <translation>&lt;b&gt;已接受：&lt;/b&gt;应用标签时它将得到标签 {0}。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Fixed.&lt;/b&gt;</source>
        <translation>&lt;b&gt;已修正。&lt;/b&gt;</translation>
    </message>
    <message>
        <source>&lt;b&gt;You hold it for no problem.&lt;/b&gt;</source>
        <translation>&lt;b&gt;您认为这不是问题。&lt;/b&gt;</translation>
    </message>
    <message>
        <source>It fits no marker: exchange it by hand, or say it is no problem.</source>
        <translation>它不属于任何标记点：请手动互换，或标为没有问题。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Fixing&lt;/b&gt; exchanges the two: dashed lines show how it will be.</source>
        <translation>&lt;b&gt;修正&lt;/b&gt;将互换两者：虚线显示互换后的样子。</translation>
    </message>
    <message>
        <source>&lt;b&gt;Fixing&lt;/b&gt; sets the samples aside: they become a gap, to be filled.</source>
        <translation>&lt;b&gt;修正&lt;/b&gt;将搁置这些采样：它们成为有待填补的缺失段。</translation>
    </message>
    <message>
        <source>To be filled with {0}, as shown.</source>
        <translation>将如图用“{0}”填补。</translation>
    </message>
    <message>
        <source>To be filled with {0}, as shown: expected error {1} mm.</source>
        <translation>将如图用“{0}”填补：预期误差 {1} mm。</translation>
    </message>
    <message>
        <source>frame {0} ({1} ms)</source>
        <translation>帧 {0} ({1} ms)</translation>
    </message>
    <message>
        <source>frames {0} – {1}: {2} ({3} ms)</source>
        <translation>帧 {0} – {1}：{2} 帧 ({3} ms)</translation>
    </message>
</context>
<context>
    <name>Suspects</name>
    <message>
        <source>Gap</source>
        <translation>缺失段</translation>
    </message>
    <message>
        <source>Spike</source>
        <translation>尖峰</translation>
    </message>
    <message>
        <source>Swap</source>
        <translation>互换</translation>
    </message>
    <message>
        <source>Fragment</source>
        <translation>片段</translation>
    </message>
    <message>
        <source>Ragged</source>
        <translation>残缺端</translation>
    </message>
    <message>
        <source>Frozen</source>
        <translation>冻结</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>骨长</translation>
    </message>
    <message>
        <source>Far</source>
        <translation>远离</translation>
    </message>
    <message>
        <source>Double</source>
        <translation>重合</translation>
    </message>
    <message>
        <source>Label?</source>
        <translation>标签？</translation>
    </message>
    <message>
        <source>Label</source>
        <translation>名称</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>手动</translation>
    </message>
    <message>
        <source>Swapped labels</source>
        <translation>标签互换</translation>
    </message>
    <message>
        <source>Fragment or ghost</source>
        <translation>片段或鬼点</translation>
    </message>
    <message>
        <source>Ragged end</source>
        <translation>残缺端</translation>
    </message>
    <message>
        <source>Frozen samples</source>
        <translation>冻结采样</translation>
    </message>
    <message>
        <source>Broken bone</source>
        <translation>骨长异常</translation>
    </message>
    <message>
        <source>Far from the body</source>
        <translation>远离身体</translation>
    </message>
    <message>
        <source>Coinciding points</source>
        <translation>重合点</translation>
    </message>
    <message>
        <source>Unsure label</source>
        <translation>不确定的标签</translation>
    </message>
    <message>
        <source>Of no label</source>
        <translation>不属于任何名称</translation>
    </message>
    <message>
        <source>Set aside by hand</source>
        <translation>手动搁置</translation>
    </message>
    <message>
        <source>Labels to review</source>
        <translation>待查看的标签</translation>
    </message>
    <message>
        <source>Proposed labels that are too unsure to be given: accept or reject each. Error: how unsure they are, times the distance to the nearest other point.</source>
        <translation>建议的标签因不够确定而不会自动给出：请逐个接受或拒绝。误差：不确定程度乘以到最近其他点的距离。</translation>
    </message>
    <message>
        <source>The rest is explained otherwise.</source>
        <translation>其余部分另有解释。</translation>
    </message>
    <message>
        <source>{0}: {1}</source>
        <translation>{0}：{1}</translation>
    </message>
    <message>
        <source>{0} mm off</source>
        <translation>偏差 {0} mm</translation>
    </message>
    <message>
        <source>{0} % sure</source>
        <translation>{0} % 把握</translation>
    </message>
</context>
<context>
    <name>TakenOff</name>
    <message>
        <source>Smoothing that depends on this was taken off, stretches: {0}. Smooth again at the end.</source>
        <translation>依赖于此的平滑已取消，区段：{0} 个。请在最后重新平滑。</translation>
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
        <source>No gap or problem is chosen: press N for the next one.</source>
        <translation>未选择缺失段或问题：按 N 转到下一个。</translation>
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
        <source>{0}, frames {1} to {2}</source>
        <translation>{0}，第 {1} 至 {2} 帧</translation>
    </message>
    <message>
        <source>{0}: smoothed, frames {1} to {2} ({3}, moved by {4} mm RMS)</source>
        <translation>{0}：已平滑，第 {1} 至 {2} 帧（{3}，移动量均方根 {4} mm）</translation>
    </message>
    <message>
        <source>{0}, frame {1}, {2} s</source>
        <translation>{0}，第 {1} 帧，{2} s</translation>
    </message>
    <message>
        <source>The recording has no frames.</source>
        <translation>此记录没有帧。</translation>
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
        <source>Current problem: {0}</source>
        <translation>当前问题：{0}</translation>
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
        <source>The bold curve is the proposed repair with its 90 % band. Nothing is changed yet. {0} shows another method.</source>
        <translation>粗曲线是建议的修复及其 90 % 置信带。此时还没有任何改动。按 {0} 可查看另一种方法。</translation>
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
    <message>
        <source>Samples that were there but wrong: {0}</source>
        <translation>存在但错误的采样：{0}</translation>
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
        <source>set aside</source>
        <translation>已搁置</translation>
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
        <source>This file has no analog channels.</source>
        <translation>此文件没有模拟通道。</translation>
    </message>
    <message>
        <source>Trails reach {0} s back and ahead.</source>
        <translation>尾迹前后各 {0} s。</translation>
    </message>
    <message>
        <source>Taken back: {0}.</source>
        <translation>已撤销：{0}。</translation>
    </message>
    <message>
        <source>Made again: {0}.</source>
        <translation>已重做：{0}。</translation>
    </message>
    <message>
        <source>This method takes no donors.</source>
        <translation>此方法不使用参考标记点。</translation>
    </message>
    <message>
        <source>Click markers to choose donors; D ends it.</source>
        <translation>点击标记点以选择参考标记点；按 D 结束。</translation>
    </message>
    <message>
        <source>Gaps: {0} filled, {1} left open.</source>
        <translation>缺失段：已填补 {0} 个，未填补 {1} 个。</translation>
    </message>
    <message>
        <source>Select a marker first.</source>
        <translation>请先选择一个标记点。</translation>
    </message>
</context>
</TS>
